// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/RefinedPolyData.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace DirectionFields
{
namespace
{
/// Gives the new points the directions of the field.
void SetDirections(
  const GivenField& field, const SurfaceRefinement& refinement, vtkIdType first, vtkPointData* data)
{
  const std::vector<Vector3> directions = DirectionsAtMiddles(field, refinement);
  for (int k = 0; k < field.GetDegree(); ++k)
  {
    vtkDataArray* const array = data->GetArray(ArrayNames::Direction(k).c_str());
    for (std::size_t i = 0; array && i < refinement.Ends.size(); ++i)
    {
      array->SetTuple(
        first + static_cast<vtkIdType>(i), directions[i * field.GetDegree() + k].data());
    }
  }
}

/// Lets new points between two that are constrained follow the field there, and others be free.
void SetConstraints(const SurfaceRefinement& refinement, vtkIdType first, vtkPointData* data)
{
  vtkDataArray* const kind = data->GetArray(ArrayNames::ConstraintKind);
  vtkDataArray* const direction = data->GetArray(ArrayNames::ConstraintDirection);
  vtkDataArray* const field = data->GetArray(ArrayNames::Direction(0).c_str());
  if (!kind || !direction || !field || kind->GetNumberOfComponents() != 1 ||
    direction->GetNumberOfComponents() != 3)
  {
    return;
  }
  for (std::size_t i = 0; i < refinement.Ends.size(); ++i)
  {
    const double a = kind->GetComponent(refinement.Ends[i][0], 0);
    const double b = kind->GetComponent(refinement.Ends[i][1], 0);
    const bool isConstrained = a != 0.0 && b != 0.0;
    const vtkIdType point = first + static_cast<vtkIdType>(i);
    kind->SetComponent(point, 0, isConstrained ? a : 0.0);
    double vector[3] = { 0.0, 0.0, 0.0 };
    if (isConstrained)
    {
      field->GetTuple(point, vector);
    }
    direction->SetTuple(point, vector);
  }
}

void CopyPoints(vtkPolyData* input, const GivenField& field, const SurfaceRefinement& refinement,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  const vtkIdType first = input->GetNumberOfPoints();
  const auto count = static_cast<vtkIdType>(refinement.Refined.Points.size());
  // VTK gives its sizes in KiB, of fewer points.
  RequireMemory(static_cast<std::size_t>(1024.0 * count / std::max<vtkIdType>(first, 1) *
    (input->GetPointData()->GetActualMemorySize() + input->GetPoints()->GetActualMemorySize())));
  points->SetNumberOfPoints(count);
  vtkPointData* const from = input->GetPointData();
  vtkPointData* const to = output->GetPointData();
  to->InterpolateAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, refinement.Refined.Points[i].data());
    if (i < first)
    {
      to->CopyData(from, i, i);
    }
    else
    {
      const std::array<Index, 2>& ends = refinement.Ends[i - first];
      to->InterpolateEdge(from, i, ends[0], ends[1], 0.5);
    }
  }
  output->SetPoints(points);
  SetDirections(field, refinement, first, to);
  SetConstraints(refinement, first, to);
}
}

vtkSmartPointer<vtkPolyData> RefinedPolyData(vtkPolyData* input,
  const TriangulatedPolyData& surface, const GivenField& field, const SurfaceRefinement& refinement)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  CopyPoints(input, field, refinement, output);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  output->SetVerts(input->GetVerts());
  output->SetLines(input->GetLines());
  std::vector<std::int64_t> offsets = { 0 };
  std::vector<std::int64_t> corners;
  for (const Triangle& triangle : refinement.Refined.Triangles)
  {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(MakeIds(offsets), MakeIds(corners));
  output->SetPolys(triangles);
  vtkCellData* const to = output->GetCellData();
  const vtkIdType others = input->GetNumberOfVerts() + input->GetNumberOfLines();
  to->CopyAllocate(input->GetCellData(), others + static_cast<vtkIdType>(refinement.Parent.size()));
  for (vtkIdType cell = 0; cell < others; ++cell)
  {
    to->CopyData(input->GetCellData(), cell, cell);
  }
  for (std::size_t t = 0; t < refinement.Parent.size(); ++t)
  {
    to->CopyData(
      input->GetCellData(), surface.Cell(refinement.Parent[t]), others + static_cast<vtkIdType>(t));
  }
  return output;
}
}
