// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A surface that is no manifold comes out split: points added, cells rewritten, data copied.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkStringArray.h"

#include <array>
#include <cmath>
#include <set>

using namespace Checks;

namespace
{
/// The field with one warning that has all the words.
vtkSmartPointer<vtkPolyData> SplitFieldOf(
  vtkPolyData* mesh, std::initializer_list<const char*> words, int degree = 4)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->Update();
  CHECK(messages->IsOneWarning(words));
  return filter->GetOutput();
}

std::vector<vtkIdType> Corners(vtkCellArray* cells, vtkIdType i)
{
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(i, ids);
  return { ids->begin(), ids->end() };
}

vtkIdType Original(vtkPolyData* field, vtkIdType point)
{
  return static_cast<vtkIdType>(
    field->GetPointData()->GetArray("OriginalPointIds")->GetTuple1(point));
}

/// Properties of every split output: added points are copies that come last, cells are the
/// input's up to copies, and all arrays have as many tuples as there are points and cells.
void CheckSplit(vtkPolyData* mesh, vtkPolyData* field, vtkIdType added)
{
  const vtkIdType before = mesh->GetNumberOfPoints();
  REQUIRE(field->GetNumberOfPoints() == before + added);
  auto originals =
    vtkIdTypeArray::SafeDownCast(field->GetPointData()->GetAbstractArray("OriginalPointIds"));
  REQUIRE(originals && originals->GetNumberOfTuples() == field->GetNumberOfPoints());
  CHECK(field->GetPoints()->GetDataType() == mesh->GetPoints()->GetDataType());
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    const vtkIdType original = originals->GetValue(i);
    REQUIRE(original >= 0 && original < before);
    CHECK(i >= before || original == i);
    double p[3], q[3];
    field->GetPoint(i, p);
    mesh->GetPoint(original, q);
    CHECK(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]);
  }

  CHECK(field->GetNumberOfCells() == mesh->GetNumberOfCells());
  CHECK(field->GetVerts()->GetNumberOfCells() == mesh->GetVerts()->GetNumberOfCells());
  CHECK(field->GetLines()->GetNumberOfCells() == mesh->GetLines()->GetNumberOfCells());
  std::set<vtkIdType> used;
  for (const bool strips : { false, true })
  {
    vtkCellArray* here = strips ? field->GetStrips() : field->GetPolys();
    vtkCellArray* there = strips ? mesh->GetStrips() : mesh->GetPolys();
    REQUIRE(here->GetNumberOfCells() == there->GetNumberOfCells());
    for (vtkIdType i = 0; i < here->GetNumberOfCells(); ++i)
    {
      const auto corners = Corners(here, i);
      const auto expected = Corners(there, i);
      REQUIRE(corners.size() == expected.size());
      for (size_t k = 0; k < corners.size(); ++k)
      {
        REQUIRE(corners[k] >= 0 && corners[k] < field->GetNumberOfPoints());
        CHECK(Original(field, corners[k]) == expected[k]);
        used.insert(corners[k]);
      }
    }
  }
  for (vtkIdType i = before; i < field->GetNumberOfPoints(); ++i)
  {
    CHECK(used.count(i) == 1);
  }

  for (int i = 0; i < field->GetPointData()->GetNumberOfArrays(); ++i)
  {
    CHECK(field->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples() ==
      field->GetNumberOfPoints());
  }
  for (int i = 0; i < field->GetCellData()->GetNumberOfArrays(); ++i)
  {
    CHECK(
      field->GetCellData()->GetAbstractArray(i)->GetNumberOfTuples() == field->GetNumberOfCells());
  }
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    if (used.count(i) == 1)
    {
      CHECK(std::abs(vtkMath::Norm(Direction(field, 0)->GetTuple3(i)) - 1.0) < 1e-6);
    }
  }
  // The input keeps its own points and cells.
  CHECK(mesh->GetNumberOfPoints() == before);
  CHECK(!mesh->GetPointData()->HasArray("OriginalPointIds"));
}

/// Pages of quads that meet in a spine along z, which belongs to the first of them.
PolyMeshes::Mesh Book(int pages, int rows, int columns, int precision = VTK_DOUBLE)
{
  std::vector<PolyMeshes::Point> points;
  PolyMeshes::Cells quads;
  for (int j = 0; j <= rows; ++j)
  {
    points.push_back({ 0.0, 0.0, 1.0 * j / rows });
  }
  for (int page = 0; page < pages; ++page)
  {
    const double angle = 0.3 + 2.0 * PolyMeshes::Pi * page / pages;
    const auto offset = static_cast<vtkIdType>(points.size());
    for (int i = 1; i <= columns; ++i)
    {
      for (int j = 0; j <= rows; ++j)
      {
        points.push_back(
          { std::cos(angle) * i / columns, std::sin(angle) * i / columns, 1.0 * j / rows });
      }
    }
    const auto number = [&](int i, int j) -> vtkIdType
    { return i == 0 ? j : offset + (i - 1) * (rows + 1) + j; };
    for (int i = 0; i < columns; ++i)
    {
      for (int j = 0; j < rows; ++j)
      {
        quads.push_back({ number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) });
      }
    }
  }
  return PolyMeshes::Make(points, quads, precision);
}

void TestQuads()
{
  for (const int precision : { VTK_DOUBLE, VTK_FLOAT })
  {
    const int pages = 3, rows = 4, columns = 3;
    auto mesh = Book(pages, rows, columns, precision);
    auto field = SplitFieldOf(mesh, { "mended", "4 edges of more than two triangles", "split" });
    CheckSplit(mesh, field, (pages - 1) * (rows + 1));

    // Each page has a spine of its own, and its field follows it.
    std::set<vtkIdType> spines;
    for (vtkIdType i = 0; i < field->GetNumberOfPolys(); ++i)
    {
      for (const vtkIdType point : Corners(field->GetPolys(), i))
      {
        const bool onSpine = Original(field, point) <= rows;
        CHECK(field->GetPointData()->GetArray("ConstraintKind")->GetTuple1(point) ==
          (onSpine ? 4.0 : 0.0));
        if (onSpine)
        {
          spines.insert(point);
          double given[3];
          field->GetPointData()->GetArray("ConstraintDirection")->GetTuple(point, given);
          double alongSpine = 0.0, alongGiven = 0.0;
          for (int k = 0; k < 4; ++k)
          {
            double d[3];
            Direction(field, k)->GetTuple(point, d);
            alongSpine = std::max(alongSpine, d[2]);
            alongGiven = std::max(alongGiven, vtkMath::Dot(d, given));
          }
          CHECK(alongSpine > 0.999999);
          CHECK(alongGiven > 0.999999);
        }
      }
    }
    CHECK(spines.size() == static_cast<size_t>(pages * (rows + 1)));
    REQUIRE(field->GetFieldData()->GetArray("EulerCharacteristic"));
    CHECK(field->GetFieldData()->GetArray("EulerCharacteristic")->GetNumberOfTuples() == pages);
    CHECK(SumOfIndices(field->GetCellData()) == 0);
    CHECK(Direction(field, 0)->GetDataType() == precision);
  }
}

/// All data of the input's points goes to the copies, whatever its kind and flags.
void TestPointData()
{
  auto mesh = Book(3, 2, 1);
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  vtkNew<vtkStringArray> labels;
  labels->SetName("labels");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  for (vtkIdType i = 0; i < points; ++i)
  {
    pairs->InsertNextTuple2(1.5 * i, -1.0 * i);
    labels->InsertNextValue("point " + std::to_string(i));
    ids->InsertNextValue(100 + i);
  }
  mesh->GetPointData()->AddArray(pairs);
  mesh->GetPointData()->AddArray(labels);
  mesh->GetPointData()->SetGlobalIds(ids);
  mesh->GetPointData()->CopyFieldOff("pairs");
  vtkNew<vtkDoubleArray> pressure;
  pressure->SetName("pressure");
  pressure->SetNumberOfTuples(mesh->GetNumberOfCells());
  pressure->FillValue(3.0);
  mesh->GetCellData()->SetScalars(pressure);

  auto field = SplitFieldOf(mesh, { "split" });
  CheckSplit(mesh, field, 6);
  auto copiedPairs = field->GetPointData()->GetArray("pairs");
  auto copiedLabels =
    vtkStringArray::SafeDownCast(field->GetPointData()->GetAbstractArray("labels"));
  auto copiedIds = field->GetPointData()->GetArray("ids");
  REQUIRE(copiedPairs && copiedLabels && copiedIds);
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    const vtkIdType original = Original(field, i);
    CHECK(copiedPairs->GetComponent(i, 0) == 1.5 * original);
    CHECK(copiedPairs->GetComponent(i, 1) == -1.0 * original);
    CHECK(copiedLabels->GetValue(i) == "point " + std::to_string(original));
    CHECK(copiedIds->GetTuple1(i) == 100 + original);
  }
  CHECK(field->GetCellData()->GetScalars() == pressure);
  CHECK(field->GetPointData()->GetVectors() == Direction(field, 0));
}

/// Vertices and lines come first in the numbering of the cells and stay on the input's points.
void TestVertsAndLines()
{
  auto mesh = Book(3, 2, 1);
  vtkNew<vtkCellArray> verts, lines;
  verts->InsertNextCell({ 1 });
  lines->InsertNextCell({ 0, 1, 2 });
  lines->InsertNextCell({ 0, 2 });
  mesh->SetVerts(verts);
  mesh->SetLines(lines);
  auto field = SplitFieldOf(mesh, { "2 edges" });
  CheckSplit(mesh, field, 6);
  CHECK(Corners(field->GetVerts(), 0) == Corners(verts, 0));
  CHECK(Corners(field->GetLines(), 0) == Corners(lines, 0));
  CHECK(Corners(field->GetLines(), 1) == Corners(lines, 1));
}

/// Strips that touch each other in a point, and one whose end touches its own beginning: the places
/// of a strip are told apart.
void TestStrips()
{
  auto one = PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 1, 0 }, { 1.5, 3, 0 },
                                { 0, 4, 0 }, { 0, 3, 0 }, { -1, 2, 0 } },
    {});
  vtkNew<vtkCellArray> loop;
  loop->InsertNextCell({ 0, 1, 2, 3, 4, 5, 6, 7, 0 });
  one->SetStrips(loop);
  auto field = SplitFieldOf(one, { "1 point where several sheets meet" });
  CheckSplit(one, field, 1);
  CHECK((Corners(field->GetStrips(), 0) == std::vector<vtkIdType>{ 0, 1, 2, 3, 4, 5, 6, 7, 8 }));
  CHECK(FieldValue(field, "EulerCharacteristic") == 1);

  auto mesh = PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 2, 1, 0 }, { 1, 3, 0 },
                                 { -1, 2, 0 }, { -1, 0.5, 0 }, { -2, 0, 0 }, { 0, -1, 0 } },
    { { 0, 7, 8 } });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  strips->InsertNextCell({ 3, 4, 2, 5, 6, 0 });
  mesh->SetStrips(strips);
  auto several = SplitFieldOf(mesh, { "split" });
  CheckSplit(mesh, several, 2);
  // The triangle and the two ends are three sheets at point 0.
  const std::set<vtkIdType> ends = { Corners(several->GetPolys(), 0)[0],
    Corners(several->GetStrips(), 0)[0], Corners(several->GetStrips(), 1)[5] };
  CHECK(ends.size() == 3);
}

/// Polygons that meet in nothing but one point get a point each.
void TestBowTie()
{
  auto mesh = PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { -1, 0, 0 },
                                 { -1, -1, 0 }, { 0, -1, 0 } },
    { { 0, 1, 2, 3 }, { 0, 4, 5, 6 } });
  auto field = SplitFieldOf(mesh, { "1 point where several sheets meet" });
  CheckSplit(mesh, field, 1);
  CHECK((Corners(field->GetPolys(), 0) == std::vector<vtkIdType>{ 0, 1, 2, 3 }));
  CHECK((Corners(field->GetPolys(), 1) == std::vector<vtkIdType>{ 7, 4, 5, 6 }));
  // Where sheets meet in a point only, nothing is constrained.
  CHECK(!field->GetPointData()->HasArray("ConstraintKind"));
}

/// A quad with two triangles more on its diagonal: it stays whole, on the points of one half.
void TestTornPolygon()
{
  auto mesh = PolyMeshes::Make(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 1 }, { 0.5, 0.5, -1 } },
    { { 0, 1, 2, 3 }, { 0, 2, 4 }, { 2, 0, 5 }, { 1, 3, 4 }, { 3, 1, 5 } });
  // Whichever diagonal it is cut by, that one has two triangles more.
  auto field = SplitFieldOf(mesh, { "1 edge" });
  CHECK((Corners(field->GetPolys(), 0) == std::vector<vtkIdType>{ 0, 1, 2, 3 }));
  for (vtkIdType i = 1; i < 5; ++i)
  {
    for (const vtkIdType corner : Corners(field->GetPolys(), i))
    {
      CHECK(corner > 3);
    }
  }
  CHECK(field->GetCellData()->GetArray("SingularityIndex")->GetNumberOfTuples() == 5);
}

/// The links of the input do not survive into the output, which builds others.
/// A triangle on the diagonal along which a quad is cut: the cut triangles get points of their own
/// that the quad cannot use. Those show no direction.
void TestUnusedPoints()
{
  vtkNew<vtkPoints> points;
  for (const auto& p :
    { std::array<double, 3>{ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 1 } })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  polys->InsertNextCell({ 1, 3, 4 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  const auto field = SplitFieldOf(mesh, { "split" });
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    for (const vtkIdType corner : Corners(field->GetPolys(), cell))
    {
      used.insert(corner);
    }
  }
  CHECK(static_cast<vtkIdType>(used.size()) < field->GetNumberOfPoints());
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    double direction[3];
    field->GetPointData()->GetArray("Direction0")->GetTuple(i, direction);
    CHECK(std::abs(vtkMath::Norm(direction) - (used.count(i) ? 1.0 : 0.0)) < 1e-6);
  }
}

void TestLinks()
{
  auto mesh = Book(3, 2, 1);
  mesh->BuildLinks();
  auto field = SplitFieldOf(mesh, { "split" });
  vtkNew<vtkIdList> cells;
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    field->GetPointCells(i, cells);
    for (const vtkIdType cell : *cells)
    {
      vtkNew<vtkIdList> points;
      field->GetCellPoints(cell, points);
      CHECK(points->IsId(i) >= 0);
    }
    CHECK(cells->GetNumberOfIds() > 0);
  }
}

/// Three triangles and their ends: the singularity of the one in the middle faces its own side.
void TestSingularityNormals()
{
  auto mesh = PolyMeshes::Make(
    { { 1, 0, 0 }, { -0.5, 0.8, 0 }, { -0.5, -0.8, 0 }, { 0, 0, -1 }, { 0, 0, 1 } },
    { { 1, 0, 3 }, { 2, 1, 3 }, { 0, 2, 3 }, { 0, 1, 2 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 0, 4 } });
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->SetDegree(1);
  filter->Update();
  CHECK(messages->IsOneWarning({ "3 edges of more than two triangles" }));
  CheckSplit(mesh, filter->GetOutput(), 6);
  vtkPointData* singularities = filter->GetOutput(1)->GetPointData();
  bool found = false;
  for (vtkIdType i = 0; i < filter->GetOutput(1)->GetNumberOfPoints(); ++i)
  {
    if (singularities->GetArray("CellId")->GetTuple1(i) == 3.0)
    {
      found = true;
      CHECK(singularities->GetArray("SingularityIndex")->GetTuple1(i) == 1.0);
      CHECK(singularities->GetNormals()->GetTuple3(i)[2] > 0.99);
    }
  }
  CHECK(found);
}

/// A manifold is not split, and arrays that an earlier filter left on its points go.
void TestManifold()
{
  vtkNew<vtkDirectionField> split, whole;
  vtkNew<Messages> messages;
  vtkNew<Messages> messagesOfWhole;
  messages->Observe(split);
  messagesOfWhole->Observe(whole);
  split->SetInputData(Book(3, 2, 1));
  whole->SetInputConnection(split->GetOutputPort());
  whole->Update();
  CHECK(messages->IsOneWarning({ "split" }));
  // Three sheets that meet along an edge stay apart.
  CHECK(messagesOfWhole->IsEmpty());
  CHECK(split->GetOutput()->GetPointData()->HasArray("OriginalPointIds"));
  CHECK(!whole->GetOutput()->GetPointData()->HasArray("OriginalPointIds"));
  CHECK(whole->GetOutput()->GetPoints() == split->GetOutput()->GetPoints());
  CHECK(whole->GetOutput()->GetPolys() == split->GetOutput()->GetPolys());

  vtkNew<vtkDirectionField> sphere;
  sphere->SetInputData(PolyMeshes::Icosphere(1));
  sphere->Update();
  CHECK(!sphere->GetOutput()->GetPointData()->HasArray("OriginalPointIds"));
}
}

int TestDirectionFieldSplit(int, char*[])
{
  TestQuads();
  TestPointData();
  TestVertsAndLines();
  TestStrips();
  TestBowTie();
  TestTornPolygon();
  TestUnusedPoints();
  TestLinks();
  TestSingularityNormals();
  TestManifold();
  return Result();
}
