// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that cannot be processed give one error and empty outputs; surfaces that can be mended
// give one warning that counts the mended faults.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkStringArray.h"

using namespace Checks;

namespace
{
void TestError(vtkPolyData* mesh, std::initializer_list<const char*> words)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->Update();
  CHECK(messages->IsOneError(words));
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  CHECK(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0);
  CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);

  // The filter works as before after the error.
  filter->SetInputData(PolyMeshes::Icosphere(1));
  filter->Update();
  CHECK(messages->Errors.size() == 1);
  CHECK(FieldValue(filter->GetOutput(), "IndexSum") == 8);
}

void TestErrors()
{
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    auto notFinite = PolyMeshes::Icosphere(1);
    notFinite->GetPoints()->SetPoint(17, 0.0, bad, 0.0);
    TestError(notFinite, { "point 17" });
    // The error is the same where a polygon has to be cut first.
    auto quads = PolyMeshes::QuadCube();
    quads->GetPoints()->SetPoint(3, bad, 0.0, 0.0);
    TestError(quads, { "point 3" });
  }

  const std::vector<PolyMeshes::Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  TestError(PolyMeshes::Make(points, { { 0, 1, 99 } }), { "point 99" });
  TestError(PolyMeshes::Make(points, { { 0, 1, 2, -1 } }), { "point -1" });
  TestError(PolyMeshes::Make(points, { { 0, 1, 5000000000 } }), { "point" });
}

vtkSmartPointer<vtkPolyData> TestWarning(
  vtkPolyData* mesh, std::initializer_list<const char*> words)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->Update();
  CHECK(messages->IsOneWarning(words));
  vtkPolyData* field = filter->GetOutput();
  // The field data says the same.
  auto texts = vtkStringArray::SafeDownCast(field->GetFieldData()->GetAbstractArray("Warnings"));
  CHECK(texts && texts->GetNumberOfTuples() == 1);
  CHECK(texts && messages->Warnings[0].find(texts->GetValue(0)) != std::string::npos);
  CHECK(field->GetNumberOfPoints() == mesh->GetNumberOfPoints());
  CHECK(field->GetNumberOfCells() == mesh->GetNumberOfCells());
  for (int k = 0; Direction(field, k); ++k)
  {
    for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
    {
      CHECK(std::abs(vtkMath::Norm(Direction(field, k)->GetTuple3(i)) - 1.0) < 1e-9);
    }
  }
  return field;
}

/// A named count of mended faults.
int RepairCount(vtkPolyData* field, const char* name)
{
  vtkDataArray* repairs = field->GetFieldData()->GetArray("Repairs");
  for (int k = 0; repairs && k < repairs->GetNumberOfComponents(); ++k)
  {
    if (repairs->GetComponentName(k) && std::string(name) == repairs->GetComponentName(k))
    {
      return static_cast<int>(repairs->GetComponent(0, k));
    }
  }
  return -1;
}

/// Three triangles on an edge.
vtkSmartPointer<vtkPolyData> TestWarningOfSplit()
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(
    PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }));
  filter->Update();
  CHECK(messages->IsOneWarning({ "1 edge of more than two triangles", "2 points where" }));
  return filter->GetOutput();
}

/// The pebble with some of its triangles replaced and others added.
PolyMeshes::Mesh Changed(
  const std::map<vtkIdType, std::vector<vtkIdType>>& replaced, const PolyMeshes::Cells& added)
{
  auto mesh = PolyMeshes::Pebble(1);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    const auto other = replaced.find(i);
    if (other != replaced.end())
    {
      polys->InsertNextCell(static_cast<vtkIdType>(other->second.size()), other->second.data());
    }
    else
    {
      mesh->GetPolys()->GetCellAtId(i, ids);
      polys->InsertNextCell(ids);
    }
  }
  for (const auto& cell : added)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  mesh->SetPolys(polys);
  return mesh;
}

void TestWarnings()
{
  vtkNew<vtkDirectionField> clean;
  clean->SetInputData(PolyMeshes::Pebble(1));
  clean->Update();
  auto corners = [](vtkIdType cell)
  {
    vtkNew<vtkIdList> ids;
    PolyMeshes::Pebble(1)->GetCellPoints(cell, ids);
    return std::vector<vtkIdType>{ ids->GetId(0), ids->GetId(1), ids->GetId(2) };
  };

  const auto a = corners(3);
  const auto b = corners(40);
  auto flipped =
    TestWarning(Changed({ { 3, { a[0], a[2], a[1] } }, { 40, { b[0], b[2], b[1] } } }, {}),
      { "2 triangles wound against the majority" });
  CHECK(LargestAngle(flipped, clean->GetOutput(), 4) < 1e-3);
  CHECK(RepairCount(flipped, "ReversedTriangles") == 2);
  CHECK(SumOfIndices(flipped->GetCellData()) == 8);

  auto duplicate = TestWarning(Changed({}, { { a[1], a[2], a[0] } }), { "1 duplicate triangle" });
  CHECK(LargestAngle(duplicate, clean->GetOutput(), 4) < 1e-3);
  CHECK(duplicate->GetCellData()->GetArray("SingularityIndex")->GetTuple1(80) == 0.0);

  auto collapsed = TestWarning(Changed({}, { { a[0], a[1], a[0] }, { b[0], b[0], b[0] } }),
    { "2 triangles with a repeated corner" });
  CHECK(LargestAngle(collapsed, clean->GetOutput(), 4) < 1e-3);
  TestWarning(Changed({}, { { a[0], a[1], a[1], a[0] } }), { "1 triangle with a repeated corner" });

  auto both = TestWarning(Changed({}, { { a[0], a[1], a[0] }, { a[1], a[2], a[0] } }),
    { "1 duplicate triangle", "1 triangle with a repeated corner" });
  CHECK(RepairCount(both, "DuplicateTriangles") == 1);
  CHECK(RepairCount(both, "CollapsedTriangles") == 1);
  CHECK(RepairCount(both, "ReversedTriangles") == 0);

  auto strip =
    TestWarning(PolyMeshes::Moebius(20), { "1 connected component that cannot be oriented" });
  CHECK(FieldValue(strip, "EulerCharacteristic") == 0);
  CHECK(RepairCount(strip, "NonOrientableComponents") == 1);
  CHECK(strip->GetFieldData()->GetArray("IndexSum")->GetNumberOfTuples() == 1);

  // Point 3 lies on the edge from 0 to 1, so that the triangle between has no area.
  auto flat = TestWarning(
    PolyMeshes::Make({ { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 1, -1, 0 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 4, 3 }, { 3, 4, 1 } }),
    { "1 triangle without area" });
  CHECK(RepairCount(flat, "DegenerateTriangles") == 1);

  auto book = TestWarningOfSplit();
  CHECK(RepairCount(book, "NonManifoldEdges") == 1);
  CHECK(RepairCount(book, "NonManifoldPoints") == 2);

  // A sound surface gives no report, also behind a filter that had something to mend.
  vtkNew<vtkDirectionField> behind;
  auto mended = vtkSmartPointer<vtkPolyData>::New();
  mended->DeepCopy(clean->GetOutput());
  mended->GetFieldData()->ShallowCopy(flipped->GetFieldData());
  behind->SetInputData(mended);
  behind->Update();
  CHECK(behind->GetOutput()->GetFieldData()->GetAbstractArray("Warnings") == nullptr);
  CHECK(RepairCount(behind->GetOutput(), "ReversedTriangles") == 0);
}

/// Triangles that share places but no points: a warning names the remedy, and it is one.
void TestSoup()
{
  auto pebble = PolyMeshes::Pebble(1);
  std::vector<PolyMeshes::Point> points;
  PolyMeshes::Cells triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < pebble->GetNumberOfPolys(); ++i)
  {
    pebble->GetPolys()->GetCellAtId(i, ids);
    const auto first = static_cast<vtkIdType>(points.size());
    triangles.push_back({ first, first + 1, first + 2 });
    for (vtkIdType k = 0; k < 3; ++k)
    {
      points.emplace_back();
      pebble->GetPoint(ids->GetId(k), points.back().data());
    }
  }
  auto soup = PolyMeshes::Make(points, triangles, VTK_FLOAT);
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(soup);
  filter->MergePointsOff();
  filter->Update();
  CHECK(messages->IsOneWarning({ "240 of the 240 points", "Switch on Merge Points" }));
  CHECK(filter->GetOutput()->GetFieldData()->GetArray("IndexSum")->GetNumberOfTuples() == 80);

  for (const int merge : { static_cast<int>(vtkDirectionField::MERGE_POINTS_ON),
         static_cast<int>(vtkDirectionField::MERGE_POINTS_AUTOMATIC) })
  {
    messages->Warnings.clear();
    filter->SetMergePoints(merge);
    filter->Update();
    CHECK(messages->IsEmpty());
    vtkPolyData* field = filter->GetOutput();
    CHECK(field->GetNumberOfPoints() == 240);
    CHECK(field->GetPoints() == soup->GetPoints());
    CHECK(field->GetPolys() == soup->GetPolys());
    CHECK(field->GetFieldData()->GetArray("IndexSum")->GetNumberOfTuples() == 1);
    CHECK(FieldValue(field, "IndexSum") == 8);
    CHECK(SumOfIndices(field->GetCellData()) == 8);
    CHECK(RepairCount(field, "MergedPoints") == 240 - 42);
  }

  filter->MergePointsOff();
  filter->Update();
  CHECK(filter->GetOutput()->GetFieldData()->GetArray("IndexSum")->GetNumberOfTuples() == 80);
}

/// Too few iterations give the field that was reached, and a warning that says what to do.
void TestConvergence()
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(PolyMeshes::Pebble(4));
  filter->SetMaximumIterations(1);
  filter->SetTolerance(1e-12);
  filter->Update();
  CHECK(messages->IsOneWarning({ "not converged", "1e-12", "Raise Maximum Iterations" }));
  CHECK(FieldValue(filter->GetOutput(), "Residual") > 1e-12);
  CHECK(FieldValue(filter->GetOutput(), "Iterations") >= 1);
  CheckDirections(filter->GetOutput(), 4, 1e-9);
}

/// A value that no clamp catches is refused.
void TestNotANumber()
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(PolyMeshes::Icosphere(1));
  filter->SetTolerance(std::nan(""));
  filter->Update();
  CHECK(messages->IsOneError({ "olerance" }));
}
}

int TestDirectionFieldErrors(int, char*[])
{
  TestErrors();
  TestWarnings();
  TestSoup();
  TestConvergence();
  TestNotANumber();
  return Result();
}
