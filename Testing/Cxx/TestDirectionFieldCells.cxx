// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of cell that polydata can have.

#include "Checks.h"

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
vtkSmartPointer<vtkPolyData> FieldOf(vtkPolyData* mesh, int degree = 4)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->Update();
  CHECK(messages->IsEmpty());
  return filter->GetOutput();
}

void TestQuads()
{
  // A quad of a plane is cut without turning the field.
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(7, 5);
  plane->Update();
  auto flat = FieldOf(plane->GetOutput());
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
  auto onQuads = FieldOf(quads);
  auto onTriangles = FieldOf(triangles);
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
  auto onStrips = FieldOf(strips);
  auto onTriangles = FieldOf(mesh);
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
    auto field = FieldOf(mesh, 6);
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

/// Concave, with repeated corners, too small: each polygon gives the triangles that can be made of it.
void TestPolygons()
{
  // The polygon is an L, which the fan from its first corner would leave.
  auto concave = PolyMeshes::Make(
    { { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 } },
    { { 5, 0, 1, 2, 3, 4 } });
  auto field = FieldOf(concave);
  CHECK(FieldValue(field, "EulerCharacteristic") == 1);
  CHECK(std::abs(FieldValue(field, "Eigenvalue")) < 1e-9);
  CHECK(vtkMath::Norm(Direction(field, 0)->GetTuple3(3)) > 0.99);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    // The corner folded over would turn the normal: the order about +z tells.
    double side[3];
    vtkMath::Cross(
      Direction(field, 0)->GetTuple3(i), std::array<double, 3>{ 0, 0, 1 }.data(), side);
    CHECK(vtkMath::Dot(side, Direction(field, 1)->GetTuple3(i)) < -0.99);
  }

  // Corners that are repeated one after the other, also at the ends, change nothing.
  auto repeated = PolyMeshes::QuadCube();
  auto cells = PolyMeshes::Cells{ { 0, 0, 3, 2, 2, 1, 0 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
    { 1, 2, 6, 5 }, { 2, 3, 7, 6, 6 }, { 3, 0, 4, 7 } };
  vtkNew<vtkCellArray> polys;
  for (const auto& cell : cells)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  auto clean = FieldOf(repeated);
  repeated->SetPolys(polys);
  auto mended = FieldOf(repeated);
  CHECK(FieldValue(mended, "IndexSum") == 8);
  CHECK(std::abs(FieldValue(mended, "Eigenvalue") - FieldValue(clean, "Eigenvalue")) < 1e-9);

  // Nothing to triangulate: a polygon of two corners beside a triangle.
  auto two = PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1 }, { 0, 1, 2 } });
  auto onTwo = FieldOf(two);
  CHECK(onTwo->GetNumberOfCells() == 2);
  CHECK(FieldValue(onTwo, "EulerCharacteristic") == 1);
}

/// A polygon without area cannot be cut by its ears; its fan is mended like any bad triangles.
void TestFlatPolygon()
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(PolyMeshes::Make(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 1, 1, 0 }, { 2, 1, 0 } },
    { { 0, 1, 2, 3 }, { 3, 5, 4, 0 } }));
  filter->Update();
  CHECK(messages->IsOneWarning({ "mended", "without area" }));
  vtkPolyData* field = filter->GetOutput();
  REQUIRE(field->GetNumberOfCells() == 2);
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    CHECK(std::abs(vtkMath::Norm(Direction(field, 0)->GetTuple3(i)) - 1.0) < 1e-9);
  }
}

/// A cell that is there once more.
PolyMeshes::Mesh WithCell(vtkPolyData* mesh, const std::vector<vtkIdType>& cell)
{
  auto more = PolyMeshes::Mesh::New();
  more->DeepCopy(mesh);
  more->GetPolys()->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  return more;
}

/// The field of a mesh of which a number of triangles are ignored as duplicates, and nothing else is wrong.
vtkSmartPointer<vtkPolyData> FieldWithDuplicates(vtkPolyData* mesh, int triangles)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->Update();
  const std::string count = " " + std::to_string(triangles) + " duplicate triangles ignored.";
  CHECK(messages->IsOneWarning({ count.c_str() }));
  vtkPolyData* field = filter->GetOutput();
  CHECK(field->GetNumberOfPoints() == mesh->GetNumberOfPoints());
  CHECK(field->GetFieldData()->GetArray("IndexSum")->GetNumberOfTuples() == 1);
  return field;
}

/// A polygon that is there twice, from whichever corner and in whichever direction, is no second sheet.
void TestDuplicatePolygons()
{
  const auto torus = PolyMeshes::QuadTorus(12, 8);
  const double eigenvalue = FieldValue(FieldOf(torus), "Eigenvalue");
  vtkNew<vtkIdList> ids;
  for (const vtkIdType polygon : { 0, 41, 95 })
  {
    torus->GetPolys()->GetCellAtId(polygon, ids);
    std::vector<vtkIdType> corners(ids->begin(), ids->end());
    for (const bool isReversed : { false, true })
    {
      if (isReversed)
      {
        std::reverse(corners.begin(), corners.end());
      }
      for (int k = 0; k < 4; ++k)
      {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        auto field = FieldWithDuplicates(WithCell(torus, corners), 2);
        CHECK(FieldValue(field, "IndexSum") == 0);
        CHECK(FieldValue(field, "EulerCharacteristic") == 0);
        CHECK(FieldValue(field, "Eigenvalue") == eigenvalue);
      }
    }
  }

  // A concave polygon of many corners, back to back with itself, with a corner that is repeated.
  std::vector<PolyMeshes::Point> points;
  std::vector<vtkIdType> star, back;
  for (int i = 0; i < 20; ++i)
  {
    const double angle = 2.0 * PolyMeshes::Pi * i / 20;
    const double radius = i % 2 == 0 ? 1.0 : 0.4;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
    star.push_back(i);
    back.insert(back.begin(), (i + 7) % 20);
  }
  back.insert(back.begin() + 3, back[3]);
  auto field = FieldWithDuplicates(PolyMeshes::Make(points, { star, back }), 18);
  CHECK(FieldValue(field, "EulerCharacteristic") == 1);
  CHECK(std::abs(FieldValue(field, "Eigenvalue")) < 1e-9);

  // The first of two polygons may be hidden.
  auto hidden = WithCell(torus, { 1, 9, 8, 0 });
  REQUIRE(hidden->GetNumberOfCells() == 97);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfTuples(hidden->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  hidden->GetCellData()->AddArray(ghosts);
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(hidden);
  filter->Update();
  CHECK(messages->IsOneWarning({ "2 triangles wound against the majority" }));
  CHECK(FieldValue(filter->GetOutput(), "EulerCharacteristic") == 0);
}

/// Polygons that come back to a place: a hole that is joined to the outline by a bridge stays one.
void TestKeyholes()
{
  // A square frame in one polygon, the places of the bridge visited twice by the same points.
  const std::vector<PolyMeshes::Point> points = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 },
    { 0, 3, 0 }, { 1, 1, 0 }, { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 } };
  const std::vector<vtkIdType> frame = { 0, 1, 2, 3, 0, 4, 7, 6, 5, 4 };
  auto open = FieldOf(PolyMeshes::Make(points, { frame }));
  CHECK(FieldValue(open, "EulerCharacteristic") == 0);
  CHECK(FieldValue(open, "IndexSum") == 0);
  // With the hole filled it is a square without singularities.
  auto filled = FieldOf(PolyMeshes::Make(points, { frame, { 4, 5, 6, 7 } }));
  CHECK(FieldValue(filled, "EulerCharacteristic") == 1);
  CHECK(std::abs(FieldValue(filled, "Eigenvalue")) < 1e-9);
  // A box whose lid is the frame with the hole filled.
  auto withBox = points;
  for (const double x : { 0.0, 3.0 })
  {
    withBox.push_back({ x, 0, -2 });
    withBox.push_back({ x, 3, -2 });
  }
  auto box = FieldOf(PolyMeshes::Make(withBox,
    { frame, { 4, 5, 6, 7 }, { 8, 9, 11, 10 }, { 0, 8, 10, 1 }, { 1, 10, 11, 2 }, { 2, 11, 9, 3 },
      { 3, 9, 8, 0 } }));
  CHECK(FieldValue(box, "EulerCharacteristic") == 2);
  CHECK(FieldValue(box, "IndexSum") == 8);

  // Where the second visits have points of their own the bridge is a slit, which MergePoints closes.
  auto twice = points;
  twice.push_back(points[0]);
  twice.push_back(points[4]);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Make(twice, { { 0, 1, 2, 3, 8, 9, 7, 6, 5, 4 } }));
  filter->MergePointsOff();
  filter->Update();
  CHECK(FieldValue(filter->GetOutput(), "EulerCharacteristic") == 1);
  filter->MergePointsOn();
  filter->Update();
  CHECK(FieldValue(filter->GetOutput(), "EulerCharacteristic") == 0);
}

/// Polygons of many corners, simple ones and such that cross themselves, are cut in time nearly linear.
void TestManyCorners()
{
  std::vector<PolyMeshes::Point> points;
  std::vector<vtkIdType> polygon, tangle;
  constexpr int corners = 30000;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * PolyMeshes::Pi * i / corners;
    const double radius = 1.0 + 0.2 * std::sin(9.0 * angle) + 0.0001 * (i % 2);
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
    polygon.push_back(i);
    tangle.push_back(static_cast<vtkIdType>(i) * 7919 % corners);
  }
  auto field = FieldOf(PolyMeshes::Make(points, { polygon }));
  CHECK(FieldValue(field, "EulerCharacteristic") == 1);
  CHECK(FieldValue(field, "IndexSum") == 0);
  CHECK(field->GetNumberOfCells() == 1);
  tangle.resize(1000);
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(PolyMeshes::Make(points, { tangle }));
  filter->Update();
  CHECK(messages->Errors.empty());
  CHECK(FieldValue(filter->GetOutput(), "EulerCharacteristic") == 1);
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
  auto field = FieldOf(mesh);
  CHECK(FieldValue(field, "EulerCharacteristic") == 1);
  CHECK(field->GetCellData()->GetArray("SingularityIndex")->GetTuple1(5) == 0.0);
  CHECK(field->GetNumberOfCells() == mesh->GetNumberOfCells());
}

/// A surface in two pieces, each with the other's cells as ghosts: both have the field of the whole,
/// and what counts adds up to it.
void TestGhostCells()
{
  auto mesh = PolyMeshes::QuadTorus(24, 12);
  auto whole = FieldOf(mesh, 3);
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
  TestPolygons();
  TestFlatPolygon();
  TestDuplicatePolygons();
  TestKeyholes();
  TestManyCorners();
  TestHiddenCells();
  TestGhostCells();
  return Result();
}
