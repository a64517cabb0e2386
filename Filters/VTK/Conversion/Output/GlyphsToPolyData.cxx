// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/GlyphsToPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Tensors/TensorArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

namespace DirectionFields
{
namespace
{
void AddGeometry(const GlyphMesh& mesh, int pointDataType, vtkPolyData* output)
{
  output->SetPoints(MakePoints(mesh.Points, pointDataType));
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
}

void AddCellArrays(const Glyphs& glyphs, vtkCellData* data)
{
  const GlyphMesh& mesh = glyphs.Mesh;
  const std::size_t size = mesh.Glyph.size();
  auto location = MakeArray<vtkIdTypeArray>("Location", 1, size);
  auto pointId = MakeArray<vtkIdTypeArray>("PointId", 1, size);
  auto branch = MakeArray<vtkIntArray>("Branch", 1, size);
  auto magnitude = MakeArray<vtkFloatArray>(ArrayNames::RepresentationMagnitude, 1, size);
  auto direction = MakeArray<vtkFloatArray>("Direction", 3, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const Index glyph = mesh.Glyph[i];
    location->SetValue(id, glyph);
    pointId->SetValue(id, glyphs.Point[glyph]);
    branch->SetValue(id, mesh.Branch[i]);
    magnitude->SetValue(id, Narrowed<float>(glyphs.Magnitude[glyph]));
    WriteVector(glyphs.Direction[static_cast<std::size_t>(glyph) * glyphs.Degree + mesh.Branch[i]],
      direction->GetPointer(0), i);
  }
  // None is the active scalars: viewers draw the glyphs in one color until they are told otherwise.
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
         location.Get(), pointId.Get(), branch.Get(), direction.Get(), magnitude.Get() })
  {
    data->AddArray(array);
  }
}

void AddTensorValues(const Glyphs& glyphs, vtkPolyData* field, vtkCellData* data)
{
  const TensorsAlong tensors(field);
  if (!tensors.AreThere())
  {
    return;
  }
  data->AddArray(MakeValues<vtkFloatArray>(ArrayNames::PrincipalValue, glyphs.Mesh.Glyph.size(),
    [&](std::size_t i)
    {
      const Index glyph = glyphs.Mesh.Glyph[i];
      const std::size_t direction =
        static_cast<std::size_t>(glyph) * glyphs.Degree + glyphs.Mesh.Branch[i];
      return tensors.At(glyphs.Point[glyph], glyphs.Direction[direction]);
    }));
}

/// Adds one number that describes all glyphs.
template <typename ArrayT>
void AddNumber(const char* name, typename ArrayT::ValueType value, vtkFieldData* data)
{
  auto array = MakeArray<ArrayT>(name, 1, 1);
  array->SetValue(0, value);
  data->AddArray(array);
}
}

void AddGlyphs(const Glyphs& glyphs, int pointDataType, vtkPolyData* field, vtkPolyData* output)
{
  AddGeometry(glyphs.Mesh, pointDataType, output);
  AddCellArrays(glyphs, output->GetCellData());
  AddTensorValues(glyphs, field, output->GetCellData());
  AddNumber<vtkIdTypeArray>(
    "NumberOfGlyphs", static_cast<vtkIdType>(glyphs.Point.size()), output->GetFieldData());
  AddNumber<vtkDoubleArray>("Spacing", glyphs.Spacing, output->GetFieldData());
}
}
