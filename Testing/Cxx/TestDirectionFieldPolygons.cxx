// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polygons of every kind: concave, flat, twice there, with keyholes, of many corners.

#include "Checks.h"
#include "Fields.h"

#include "vtkDirectionField.h"

using namespace Checks;

namespace
{
/// Concave, with repeated corners, too small: each polygon gives the triangles that can be made of it.
void TestPolygons()
{
  // The polygon is an L, which the fan from its first corner would leave.
  auto concave = PolyMeshes::Make(
    { { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 } },
    { { 5, 0, 1, 2, 3, 4 } });
  auto field = QuietField(concave);
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
  auto clean = QuietField(repeated);
  repeated->SetPolys(polys);
  auto mended = QuietField(repeated);
  CHECK(FieldValue(mended, "IndexSum") == 8);
  CHECK(std::abs(FieldValue(mended, "Eigenvalue") - FieldValue(clean, "Eigenvalue")) < 1e-9);

  // Nothing to triangulate: a polygon of two corners beside a triangle.
  auto two = PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1 }, { 0, 1, 2 } });
  auto onTwo = QuietField(two);
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
  const double eigenvalue = FieldValue(QuietField(torus), "Eigenvalue");
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
  auto open = QuietField(PolyMeshes::Make(points, { frame }));
  CHECK(FieldValue(open, "EulerCharacteristic") == 0);
  CHECK(FieldValue(open, "IndexSum") == 0);
  // With the hole filled it is a square without singularities.
  auto filled = QuietField(PolyMeshes::Make(points, { frame, { 4, 5, 6, 7 } }));
  CHECK(FieldValue(filled, "EulerCharacteristic") == 1);
  CHECK(std::abs(FieldValue(filled, "Eigenvalue")) < 1e-9);
  // A box whose lid is the frame with the hole filled.
  auto withBox = points;
  for (const double x : { 0.0, 3.0 })
  {
    withBox.push_back({ x, 0, -2 });
    withBox.push_back({ x, 3, -2 });
  }
  auto box = QuietField(PolyMeshes::Make(withBox,
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
  auto field = QuietField(PolyMeshes::Make(points, { polygon }));
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
}

int TestDirectionFieldPolygons(int, char*[])
{
  TestPolygons();
  TestFlatPolygon();
  TestDuplicatePolygons();
  TestKeyholes();
  TestManyCorners();
  return Result();
}
