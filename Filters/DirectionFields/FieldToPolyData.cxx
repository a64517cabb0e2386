// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FieldToPolyData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <cmath>
#include <string>

namespace DirectionFields
{
namespace
{
/// The largest degree, hence the most directions that an earlier run can have left.
constexpr int MostDirections = 16;

std::string DirectionName(int k)
{
  return "Direction" + std::to_string(k);
}

template <typename ArrayT>
vtkNew<ArrayT> MakeArray(const char* name, int components, size_t tuples)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

template <typename ArrayT>
void AddPointArrays(const Result& field, vtkPointData* data)
{
  using Value = typename ArrayT::ValueType;
  const size_t points = field.Representation.size();
  auto magnitude = MakeArray<ArrayT>("RepresentationMagnitude", 1, points);
  for (size_t i = 0; i < points; ++i)
  {
    magnitude->SetValue(
      static_cast<vtkIdType>(i), static_cast<Value>(std::abs(field.Representation[i])));
  }
  data->AddArray(magnitude);

  for (int k = 0; k < field.Degree; ++k)
  {
    auto directions = MakeArray<ArrayT>(DirectionName(k).c_str(), 3, points);
    for (size_t i = 0; i < points; ++i)
    {
      const Vector3 direction = field.Direction(static_cast<Index>(i), k);
      for (int c = 0; c < 3; ++c)
      {
        directions->SetTypedComponent(
          static_cast<vtkIdType>(i), c, static_cast<Value>(direction[c]));
      }
    }
    data->AddArray(directions);
  }
  // What an earlier run of higher degree left in the input is no part of this field.
  for (int k = field.Degree; k < MostDirections; ++k)
  {
    data->RemoveArray(DirectionName(k).c_str());
  }
  data->SetActiveVectors(DirectionName(0).c_str());
}

void AddCellArrays(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  auto index = MakeArray<vtkIntArray>(
    "SingularityIndex", 1, static_cast<size_t>(output->GetNumberOfCells()));
  index->FillValue(0);
  for (size_t t = 0; t < field.SingularityIndex.size(); ++t)
  {
    const vtkIdType cell = input.CellOfTriangle[t];
    index->SetValue(cell, index->GetValue(cell) + field.SingularityIndex[t]);
  }
  output->GetCellData()->AddArray(index);
}

template <typename ArrayT, typename Member>
void AddComponentArray(
  const char* name, const Result& field, Member ComponentReport::*member, vtkFieldData* data)
{
  auto array = MakeArray<ArrayT>(name, 1, field.Components.size());
  for (size_t c = 0; c < field.Components.size(); ++c)
  {
    array->SetValue(static_cast<vtkIdType>(c), field.Components[c].*member);
  }
  data->AddArray(array);
}

/// The normal of a triangle on the side of its vertices' normals, which a triangle wound against
/// its neighbours or one without area does not give by itself.
Vector3 OutwardNormal(const Surface& mesh, const Triangle& triangle, const Result& field)
{
  const Vector3& origin = mesh.Points[triangle[0]];
  const Vector3 normal =
    (mesh.Points[triangle[1]] - origin).cross(mesh.Points[triangle[2]] - origin).stableNormalized();
  const Vector3 outward =
    field.Normal[triangle[0]] + field.Normal[triangle[1]] + field.Normal[triangle[2]];
  if (normal.squaredNorm() < 0.5)
  {
    return outward.stableNormalized();
  }
  return normal.dot(outward) < 0.0 ? Vector3(-normal) : normal;
}
}

void AddFieldArrays(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  if (output->GetPoints() && output->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    AddPointArrays<vtkDoubleArray>(field, output->GetPointData());
  }
  else
  {
    AddPointArrays<vtkFloatArray>(field, output->GetPointData());
  }
  AddCellArrays(input, field, output);

  vtkFieldData* data = output->GetFieldData();
  AddComponentArray<vtkDoubleArray>("Eigenvalue", field, &ComponentReport::Eigenvalue, data);
  AddComponentArray<vtkDoubleArray>("Residual", field, &ComponentReport::Residual, data);
  AddComponentArray<vtkIntArray>("Iterations", field, &ComponentReport::Iterations, data);
  AddComponentArray<vtkIntArray>(
    "EulerCharacteristic", field, &ComponentReport::EulerCharacteristic, data);
  AddComponentArray<vtkIntArray>("IndexSum", field, &ComponentReport::IndexSum, data);
}

void MakeSingularities(const TriangulatedPolyData& input, const Result& field, int pointDataType,
  vtkPolyData* singularities)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointDataType == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkCellArray> verts;
  auto index = MakeArray<vtkIntArray>("SingularityIndex", 1, 0);
  auto fraction = MakeArray<vtkDoubleArray>("Index", 1, 0);
  auto cells = MakeArray<vtkIdTypeArray>("CellId", 1, 0);
  auto normals = MakeArray<vtkFloatArray>("Normals", 3, 0);

  const Surface& mesh = input.Mesh;
  for (size_t t = 0; t < field.SingularityIndex.size(); ++t)
  {
    if (field.SingularityIndex[t] == 0)
    {
      continue;
    }
    const Triangle& triangle = mesh.Triangles[t];
    const Vector3 centroid =
      (mesh.Points[triangle[0]] + mesh.Points[triangle[1]] + mesh.Points[triangle[2]]) / 3.0;
    const vtkIdType id = points->InsertNextPoint(centroid.data());
    verts->InsertNextCell(1, &id);
    index->InsertNextValue(field.SingularityIndex[t]);
    fraction->InsertNextValue(static_cast<double>(field.SingularityIndex[t]) / field.Degree);
    cells->InsertNextValue(input.CellOfTriangle[t]);
    normals->InsertNextTuple(OutwardNormal(mesh, triangle, field).data());
  }

  singularities->SetPoints(points);
  singularities->SetVerts(verts);
  vtkPointData* data = singularities->GetPointData();
  data->AddArray(index);
  data->AddArray(fraction);
  data->AddArray(cells);
  data->SetNormals(normals);
}
}
