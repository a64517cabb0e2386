// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of cell that polydata can have; of polygons, more is in TestDirectionFieldPolygons.

#include "Checks.h"
#include "Fields.h"

#include "vtkDirectionField.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPlaneSource.h"
#include "vtkStripper.h"
#include "vtkSuperquadricSource.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

using namespace Checks;

namespace
{
void TestQuads()
{
  // A quad of a plane is cut without turning the field.
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(7, 5);
  plane->Update();
  auto flat = QuietField(plane->GetOutput());
  CHECK(flat->GetNumberOfCells() == 35);
  CHECK(std::abs(FieldValue(flat, "Eigenvalue")) < 1e-9);
  CHECK(SumOfIndices(flat->GetCellData()) == 0);

  // The quads of a torus, and the same cut by VTK.
  auto quads = PolyMeshes::QuadTorus(24, 12);
  vtkNew<vtkTriangleFilter> cut;
  cut->SetInputData(quads);
  cut->Update();
  auto triangles = cut->GetOutput();
  CHECK(triangles->GetNumberOfCells() == 2 * quads->GetNumberOfCells());
  auto onQuads = QuietField(quads);
  auto onTriangles = QuietField(triangles);
  CheckDirections(onTriangles, 4, 1e-12);
  CHECK(LargestAngle(onQuads, onTriangles, 4) < 1e-3);
  CHECK(onQuads->GetCellData()->GetArray("SingularityIndex")->GetNumberOfTuples() == 24 * 12);

  vtkNew<vtkSuperquadricSource> superquadric;
  superquadric->ToroidalOn();
  superquadric->Update();
  // The source closes no seam; across seams, the filter does.
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputConnection(superquadric->GetOutputPort());
  filter->Update();
  CHECK(messages->IsEmpty());
  CHECK(filter->GetOutput()->GetFieldData()->GetArray("IndexSum")->GetNumberOfTuples() == 1);
  CHECK(Direction(filter->GetOutput(), 3) != nullptr);
}

/// Strips in whatever order give the field of their triangles; the index of a strip is the sum.
void TestStrips()
{
  auto mesh = PolyMeshes::Pebble(2);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(mesh);
  stripper->Update();
  vtkPolyData* strips = stripper->GetOutput();
  REQUIRE(strips->GetNumberOfStrips() > 1);
  REQUIRE(strips->GetNumberOfCells() < mesh->GetNumberOfCells() / 2);
  auto onStrips = QuietField(strips);
  auto onTriangles = QuietField(mesh);
  CHECK(LargestAngle(onStrips, onTriangles, 4) < 1e-3);
  CHECK(SumOfIndices(onStrips->GetCellData()) == 8);
  CHECK(onStrips->GetCellData()->GetArray("SingularityIndex")->GetNumberOfTuples() ==
    strips->GetNumberOfCells());
}

/// Vertices and lines stay, count in the order of the cells, and get the index 0.
void TestVertsAndLines()
{
  auto mesh = PolyMeshes::Pebble(2);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(mesh);
  stripper->Update();
  vtkPolyData* strips = stripper->GetOutput();

  // There are all four kinds of cells: the first half of the triangles, and the strips of another pebble.
  auto twice = PolyMeshes::BesideEachOther(mesh, mesh, 5.0);
  const vtkIdType triangles = mesh->GetNumberOfCells();
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkNew<vtkCellArray> polys, stripCells, verts, lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    polys->InsertNextCell(ids);
  }
  for (vtkIdType i = 0; i < strips->GetStrips()->GetNumberOfCells(); ++i)
  {
    strips->GetStrips()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      ids->SetId(k, ids->GetId(k) + points);
    }
    stripCells->InsertNextCell(ids);
  }
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 1, 2, 3 });
  lines->InsertNextCell({ 4, 5, 6 });
  twice->SetVerts(verts);
  twice->SetLines(lines);
  twice->SetPolys(polys);
  twice->SetStrips(stripCells);
  vtkNew<vtkDoubleArray> mine;
  mine->SetName("mine");
  mine->SetNumberOfTuples(twice->GetNumberOfCells());
  mine->FillValue(7.0);
  twice->GetCellData()->AddArray(mine);

  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(twice);
  filter->Update();
  vtkPolyData* field = filter->GetOutput();
  CHECK(field->GetNumberOfVerts() == 2 && field->GetNumberOfLines() == 1);
  CHECK(field->GetCellData()->GetArray("mine") == mine);
  auto index = vtkIntArray::SafeDownCast(field->GetCellData()->GetArray("SingularityIndex"));
  REQUIRE(index && index->GetNumberOfTuples() == twice->GetNumberOfCells());
  int sums[3] = { 0, 0, 0 };
  for (vtkIdType cell = 0; cell < index->GetNumberOfTuples(); ++cell)
  {
    sums[cell < 3 ? 0 : (cell < 3 + triangles ? 1 : 2)] += index->GetValue(cell);
  }
  CHECK(index->GetValue(0) == 0 && index->GetValue(1) == 0 && index->GetValue(2) == 0);
  CHECK(sums[1] == 8 && sums[2] == 8);
  vtkDataArray* cells = filter->GetOutput(1)->GetPointData()->GetArray("CellId");
  double range[2];
  cells->GetRange(range);
  CHECK(range[0] >= 3 && range[1] >= 3 + triangles);
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    CHECK(index->GetValue(static_cast<vtkIdType>(cells->GetTuple1(i))) != 0 ||
      cells->GetTuple1(i) >= 3 + triangles);
  }
}

/// An input without polygons and strips has the zero field, which is no error.
void TestWithoutSurface()
{
  for (const bool withCells : { false, true })
  {
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.0);
    points->InsertNextPoint(1.0, 0.0, 0.0);
    mesh->SetPoints(points);
    if (withCells)
    {
      vtkNew<vtkCellArray> verts, lines;
      verts->InsertNextCell({ 0 });
      lines->InsertNextCell({ 0, 1 });
      mesh->SetVerts(verts);
      mesh->SetLines(lines);
    }
    auto field = QuietField(mesh, 6);
    REQUIRE(field->GetNumberOfPoints() == 2);
    CHECK(field->GetNumberOfCells() == (withCells ? 2 : 0));
    for (int k = 0; k < 6; ++k)
    {
      REQUIRE(Direction(field, k));
      CHECK(vtkMath::Norm(Direction(field, k)->GetTuple3(0)) == 0.0);
      CHECK(vtkMath::Norm(Direction(field, k)->GetTuple3(1)) == 0.0);
    }
    CHECK(SumOfIndices(field->GetCellData()) == 0);
    CHECK(field->GetFieldData()->GetArray("Eigenvalue")->GetNumberOfTuples() == 0);
  }

  vtkNew<vtkPolyData> empty;
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(empty);
  filter->Update();
  CHECK(messages->IsEmpty());
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
}

/// Cells marked as hidden take no part, as if they were absent.
void TestHiddenCells()
{
  auto mesh = PolyMeshes::Pebble(1);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfTuples(mesh->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(5, vtkDataSetAttributes::HIDDENCELL);
  mesh->GetCellData()->AddArray(ghosts);
  auto field = QuietField(mesh);
  CHECK(FieldValue(field, "EulerCharacteristic") == 1);
  CHECK(field->GetCellData()->GetArray("SingularityIndex")->GetTuple1(5) == 0.0);
  CHECK(field->GetNumberOfCells() == mesh->GetNumberOfCells());
}

/// A surface in two pieces, each with the other's cells as ghosts: both have the field of the whole,
/// and what counts adds up to it.
void TestGhostCells()
{
  auto mesh = PolyMeshes::QuadTorus(24, 12);
  auto whole = QuietField(mesh, 3);
  auto wholeIndex = whole->GetCellData()->GetArray("SingularityIndex");
  double characteristic = 0.0;
  double indexSum = 0.0;
  vtkIdType singularities = 0;
  vtkIdType singular = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    singular += wholeIndex->GetTuple1(i) != 0.0;
  }
  for (const int piece : { 0, 1 })
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    part->ShallowCopy(mesh);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName("vtkGhostType");
    ghosts->SetNumberOfTuples(mesh->GetNumberOfCells());
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      // The cut is oblique, so that the number of a cell does not tell its piece.
      ghosts->SetValue(i, (i / 7) % 2 == piece ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
    part->GetCellData()->AddArray(ghosts);
    vtkNew<vtkDirectionField> filter;
    filter->SetInputData(part);
    filter->SetDegree(3);
    filter->Update();
    vtkPolyData* field = filter->GetOutput();
    CHECK(IsSame(Direction(field, 0), Direction(whole, 0)));
    CHECK(IsSame(field->GetCellData()->GetArray("SingularityIndex"), wholeIndex));
    characteristic += FieldValue(field, "EulerCharacteristic");
    indexSum += FieldValue(field, "IndexSum");
    vtkPolyData* points = filter->GetOutput(1);
    singularities += points->GetNumberOfPoints();
    vtkDataArray* cells = points->GetPointData()->GetArray("CellId");
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      CHECK(ghosts->GetValue(static_cast<vtkIdType>(cells->GetTuple1(i))) == 0);
    }

    // The filter notices that a cell has another owner.
    ghosts->SetValue(0, piece == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    ghosts->Modified();
    part->Modified();
    const double before = FieldValue(field, "EulerCharacteristic");
    filter->Update();
    CHECK(FieldValue(filter->GetOutput(), "EulerCharacteristic") != before);
  }
  CHECK(singular > 0);
  CHECK(singularities == singular);
  CHECK(characteristic == FieldValue(whole, "EulerCharacteristic"));
  CHECK(indexSum == FieldValue(whole, "IndexSum"));
}
}

int TestDirectionFieldCells(int, char*[])
{
  TestQuads();
  TestStrips();
  TestVertsAndLines();
  TestWithoutSurface();
  TestHiddenCells();
  TestGhostCells();
  return Result();
}
