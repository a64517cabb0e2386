// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/GivenPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataToField.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <stdexcept>

namespace DirectionFields
{
namespace
{
/// The number of the cell arrays Direction0, Direction1, ... of three components; 0 without any.
int DegreeOfCells(vtkPolyData* polyData)
{
  int degree = 0;
  while (degree < LargestDegree)
  {
    vtkDataArray* array = polyData->GetCellData()->GetArray(ArrayNames::Direction(degree).c_str());
    if (!array || array->GetNumberOfComponents() != 3)
    {
      break;
    }
    ++degree;
  }
  return degree;
}

/// The directions of triangles, which are the polygons.
std::vector<Vector3> DirectionsOfCells(vtkPolyData* polyData, std::size_t triangles)
{
  vtkDataArray* array = polyData->GetCellData()->GetArray(ArrayNames::Direction(0).c_str());
  const vtkIdType first = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  std::vector<Vector3> directions(triangles);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    array->GetTuple(first + static_cast<vtkIdType>(t), directions[t].data());
    if (!directions[t].allFinite())
    {
      directions[t].setZero();
    }
  }
  return directions;
}
}

bool HasOnlyTriangles(vtkPolyData* polyData)
{
  return polyData->GetNumberOfStrips() == 0 &&
    (polyData->GetNumberOfPolys() == 0 || polyData->GetPolys()->IsHomogeneous() == 3) &&
    !polyData->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName());
}

void RequireTriangles(vtkPolyData* polyData)
{
  if (polyData->GetNumberOfStrips() > 0 ||
    (polyData->GetNumberOfPolys() > 0 && polyData->GetPolys()->IsHomogeneous() != 3))
  {
    throw std::invalid_argument(
      "The surface has cells that are no triangles; other programs would cut and number them in their own way. "
      "Apply Triangulate first, and Direction Field after it.");
  }
  if (polyData->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()))
  {
    throw std::invalid_argument(
      "The surface has ghost cells (the cell array vtkGhostType), which other programs do not know. "
      "Apply Remove Ghost Information first.");
  }
}

std::vector<ExportedFile> FilesOfPolyData(
  vtkPolyData* polyData, const Surface& surface, const ExportOptions& options)
{
  const int cellDegree = options.On == FieldOn::Points ? 0 : DegreeOfCells(polyData);
  PointDirections directions = FindDirections(polyData);
  if (cellDegree == 0)
  {
    directions = RequireDirections(polyData);
  }
  else if (directions.Degree != cellDegree)
  {
    // The directions of the cells say everything.
    directions.Degree = cellDegree;
    directions.Direction = [](Index, int) { return Vector3(Vector3::Zero()); };
    directions.Magnitude = [](Index) { return 0.0; };
  }
  const GivenField field(surface, directions);
  if (cellDegree == 0)
  {
    return ExportField(field, nullptr, options);
  }
  const FaceField faces = FromVectors(
    field.GetGeometry(), cellDegree, DirectionsOfCells(polyData, surface.Triangles.size()), 1);
  return ExportField(field, &faces, options);
}
}
