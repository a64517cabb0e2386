// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "GlyphsToPolyData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>

namespace DirectionFields
{
namespace
{
/// A dark teal.
constexpr unsigned char GlyphColor[3] = { 0, 107, 117 };

vtkDataArray* FindDirection(vtkPolyData* polyData, int k)
{
  vtkDataArray* array =
    polyData->GetPointData()->GetArray(("Direction" + std::to_string(k)).c_str());
  return array && array->GetNumberOfComponents() == 3 ? array : nullptr;
}

template <typename ArrayT>
vtkNew<ArrayT> MakeArray(const char* name, int components, std::size_t tuples)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

template <typename ArrayT>
vtkNew<ArrayT> MakeVectors(const char* name, const std::vector<Vector3>& vectors)
{
  auto array = MakeArray<ArrayT>(name, 3, vectors.size());
  auto* values = array->GetPointer(0);
  for (const Vector3& vector : vectors)
  {
    for (int c = 0; c < 3; ++c)
    {
      *values++ = static_cast<typename ArrayT::ValueType>(vector[c]);
    }
  }
  return array;
}

vtkNew<vtkIdTypeArray> MakeIds(const std::vector<std::int64_t>& ids)
{
  auto array = MakeArray<vtkIdTypeArray>("", 1, ids.size());
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  return array;
}
}

PointDirections FindDirections(vtkPolyData* polyData)
{
  PointDirections field;
  std::vector<vtkDataArray*> arrays;
  while (vtkDataArray* array = FindDirection(polyData, static_cast<int>(arrays.size())))
  {
    arrays.push_back(array);
  }
  field.Degree = static_cast<int>(arrays.size());
  field.Direction = [arrays](Index point, int k)
  {
    Vector3 direction;
    arrays[k]->GetTuple(point, direction.data());
    return direction;
  };
  vtkDataArray* magnitude = polyData->GetPointData()->GetArray("RepresentationMagnitude");
  field.Magnitude = [magnitude](Index point)
  { return magnitude ? magnitude->GetComponent(point, 0) : 1.0; };
  return field;
}

std::vector<char> GhostTriangles(vtkPolyData* polyData, const TriangulatedPolyData& surface)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    polyData->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  std::vector<char> excluded;
  if (ghosts)
  {
    for (std::size_t t = 0; t < surface.Mesh.Triangles.size(); ++t)
    {
      excluded.push_back((ghosts->GetValue(surface.Cell(t)) &
                           (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL))
          ? 1
          : 0);
    }
  }
  return excluded;
}

std::vector<char> GhostPoints(vtkPolyData* polyData)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    polyData->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  std::vector<char> excluded;
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfTuples(); ++i)
  {
    excluded.push_back(
      (ghosts->GetValue(i) &
        (vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT))
        ? 1
        : 0);
  }
  return excluded;
}

void AddGlyphs(const Glyphs& glyphs, int pointDataType, vtkPolyData* output)
{
  const GlyphMesh& mesh = glyphs.Mesh;
  vtkNew<vtkPoints> points;
  if (pointDataType == VTK_DOUBLE)
  {
    points->SetData(MakeVectors<vtkDoubleArray>("Points", mesh.Points));
  }
  else
  {
    points->SetData(MakeVectors<vtkFloatArray>("Points", mesh.Points));
  }
  output->SetPoints(points);
  output->GetPointData()->SetNormals(MakeVectors<vtkFloatArray>("Normals", mesh.Normals));

  vtkNew<vtkCellArray> cells;
  cells->SetData(MakeIds(mesh.Offsets), MakeIds(mesh.Connectivity));
  if (mesh.AreLines)
  {
    output->SetLines(cells);
  }
  else
  {
    output->SetPolys(cells);
  }

  const std::size_t size = mesh.Glyph.size();
  auto location = MakeArray<vtkIdTypeArray>("Location", 1, size);
  auto pointId = MakeArray<vtkIdTypeArray>("PointId", 1, size);
  auto branch = MakeArray<vtkIntArray>("Branch", 1, size);
  auto magnitude = MakeArray<vtkFloatArray>("RepresentationMagnitude", 1, size);
  auto color = MakeArray<vtkUnsignedCharArray>("GlyphColor", 3, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const Index glyph = mesh.Glyph[i];
    location->SetValue(id, glyph);
    pointId->SetValue(id, glyphs.Point[glyph]);
    branch->SetValue(id, mesh.Branch[i]);
    magnitude->SetValue(id, static_cast<float>(glyphs.Magnitude[glyph]));
    color->SetTypedTuple(id, GlyphColor);
  }
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
         location.Get(), pointId.Get(), branch.Get(), magnitude.Get() })
  {
    output->GetCellData()->AddArray(array);
  }
  output->GetCellData()->SetScalars(color);

  auto number = MakeArray<vtkIdTypeArray>("NumberOfGlyphs", 1, 1);
  number->SetValue(0, static_cast<vtkIdType>(glyphs.Point.size()));
  output->GetFieldData()->AddArray(number);
  auto spacing = MakeArray<vtkDoubleArray>("Spacing", 1, 1);
  spacing->SetValue(0, glyphs.Spacing);
  output->GetFieldData()->AddArray(spacing);
}
}
