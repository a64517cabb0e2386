// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The directions of cells, CellDirections.

#include "Fields.h"
#include "PipelineChecks.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace Checks;

namespace
{
/// The normal of a triangle or another polygon.
void CellNormal(vtkPolyData* mesh, vtkIdType cell, double normal[3])
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  double p[3], a[3], b[3];
  mesh->GetPoint(ids->GetId(0), p);
  mesh->GetPoint(ids->GetId(1), a);
  mesh->GetPoint(ids->GetId(2), b);
  vtkMath::Subtract(a, p, a);
  vtkMath::Subtract(b, p, b);
  vtkMath::Cross(a, b, normal);
  vtkMath::Normalize(normal);
}

/// Unit vectors in the planes of the cells, and the indices that other programs find.
void TestTriangles()
{
  for (const int degree : { 1, 2, 4, 6 })
  {
    vtkNew<vtkDirectionField> filter;
    filter->SetInputData(PolyMeshes::Pebble(3));
    filter->SetDegree(degree);
    filter->CellDirectionsOn();
    filter->Update();
    vtkPolyData* field = filter->GetOutput();
    vtkDataArray* first = field->GetCellData()->GetArray("Direction0");
    vtkDataArray* next =
      field->GetCellData()->GetArray(("Direction" + std::to_string(1 % degree)).c_str());
    REQUIRE(first && next && first->GetNumberOfTuples() == field->GetNumberOfCells());
    CHECK(!field->GetCellData()->HasArray(("Direction" + std::to_string(degree)).c_str()));
    double worst = 0.0;
    for (vtkIdType i = 0; i < field->GetNumberOfCells(); ++i)
    {
      double d[3], e[3], normal[3], side[3];
      first->GetTuple(i, d);
      next->GetTuple(i, e);
      CellNormal(field, i, normal);
      vtkMath::Cross(normal, d, side);
      const double angle = 2.0 * PolyMeshes::Pi / degree;
      worst = std::max({ worst, std::abs(vtkMath::Norm(d) - 1.0), std::abs(vtkMath::Dot(d, normal)),
        std::abs(vtkMath::Dot(d, e) - std::cos(angle)),
        std::abs(vtkMath::Dot(side, e) - std::sin(angle)) });
    }
    CHECK(worst < 1e-12);
    vtkDataArray* indices = field->GetPointData()->GetArray("FaceSingularityIndex");
    REQUIRE(indices);
    int sum = 0;
    for (vtkIdType i = 0; i < indices->GetNumberOfTuples(); ++i)
    {
      sum += static_cast<int>(indices->GetComponent(i, 0));
    }
    CHECK(sum == 2 * degree);

    // Without the option the arrays that an earlier filter left are no part of the field.
    vtkNew<vtkDirectionField> later;
    later->SetInputData(field);
    later->SetDegree(degree);
    later->Update();
    CHECK(!later->GetOutput()->GetCellData()->HasArray("Direction0"));
    CHECK(!later->GetOutput()->GetPointData()->HasArray("FaceSingularityIndex"));
  }
}

/// Polygons have the directions at their centroids; lines have none.
void TestPolygons()
{
  auto torus = PolyMeshes::QuadTorus(24, 12);
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(torus);
  vtkNew<vtkCellArray> lines;
  const vtkIdType ends[2] = { 0, 1 };
  lines->InsertNextCell(2, ends);
  mesh->SetLines(lines);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetDegree(4);
  filter->CellDirectionsOn();
  filter->Update();
  vtkPolyData* field = filter->GetOutput();
  vtkDataArray* directions = field->GetCellData()->GetArray("Direction0");
  REQUIRE(directions && directions->GetNumberOfTuples() == 1 + 24 * 12);
  CHECK(vtkMath::Norm(directions->GetTuple(0)) == 0.0);
  double worst = 0.0;
  double off = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 1; i < field->GetNumberOfCells(); ++i)
  {
    double d[3], normal[3];
    directions->GetTuple(i, d);
    CellNormal(field, i, normal);
    worst =
      std::max({ worst, std::abs(vtkMath::Norm(d) - 1.0), std::abs(vtkMath::Dot(d, normal)) });
    // The corners' directions are near.
    field->GetCellPoints(i, ids);
    double nearest = PolyMeshes::Pi;
    for (vtkIdType c = 0; c < 4; ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        double e[3];
        Direction(field, k)->GetTuple(ids->GetId(c), e);
        nearest = std::min(nearest, vtkMath::AngleBetweenVectors(d, e));
      }
    }
    off = std::max(off, nearest);
  }
  CHECK(worst < 0.05);
  CHECK(off < vtkMath::RadiansFromDegrees(30.0));
}
}

int TestDirectionFieldCellDirections(int, char*[])
{
  TestTriangles();
  TestPolygons();
  return Result();
}
