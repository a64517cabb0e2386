// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// However the input stores its numbers, and whoever else computes at the time: the same field.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"

#include <thread>

using namespace Checks;

namespace
{
vtkSmartPointer<vtkPolyData> FieldOf(vtkPolyData* mesh, int degree = 4)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->Update();
  return filter->GetOutput();
}

/// All that is computed is the same to the last byte.
void CheckSame(vtkPolyData* one, vtkPolyData* other)
{
  CHECK(IsSame(one->GetPointData(), other->GetPointData()));
  CHECK(IsSame(one->GetCellData(), other->GetCellData()));
  CHECK(IsSame(one->GetFieldData(), other->GetFieldData()));
}

PolyMeshes::Mesh WithVertsAndLines()
{
  auto mesh = PolyMeshes::QuadTorus(20, 10);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 3 });
  verts->InsertNextCell({ 5, 7, 11 });
  mesh->SetVerts(verts);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2, 3 });
  mesh->SetLines(lines);
  return mesh;
}

/// Connectivity of 32 and of 64 bits.
void TestCellArrays()
{
  auto narrow = WithVertsAndLines();
  auto wide = WithVertsAndLines();
  for (const auto& [mesh, is64] : { std::pair(narrow, false), std::pair(wide, true) })
  {
    for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys() })
    {
      CHECK(is64 ? cells->ConvertTo64BitStorage() : cells->ConvertTo32BitStorage());
      CHECK(cells->IsStorage64Bit() == is64);
    }
  }
  auto one = FieldOf(narrow);
  auto other = FieldOf(wide);
  CheckSame(one, other);
  CheckDirections(FieldOf(PolyMeshes::Pebble(2)), 4, 1e-9);
  for (const auto& [field, mesh] : { std::pair(one, narrow), std::pair(other, wide) })
  {
    CHECK(field->GetVerts() == mesh->GetVerts());
    CHECK(field->GetLines() == mesh->GetLines());
    CHECK(field->GetPolys() == mesh->GetPolys());
    CHECK(field->GetCellData()->GetArray("SingularityIndex")->GetNumberOfTuples() == 203);
  }

  // Where the surface is split, its new cells are there in either storage, too.
  for (const bool is64 : { false, true })
  {
    auto book =
      PolyMeshes::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } },
        { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });
    CHECK(
      is64 ? book->GetPolys()->ConvertTo64BitStorage() : book->GetPolys()->ConvertTo32BitStorage());
    vtkNew<vtkDirectionField> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(book);
    filter->Update();
    CHECK(messages->IsOneWarning({ "split" }));
    CHECK(filter->GetOutput()->GetNumberOfPoints() == 9);
    CHECK(filter->GetOutput()->GetPolys()->IsStorage64Bit() == is64);
  }
}

/// Ids beyond 32 bits do not wrap around to valid ones.
void TestLargeIds()
{
  const std::vector<PolyMeshes::Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  for (const vtkIdType base : { vtkIdType(1) << 31, vtkIdType(1) << 32, vtkIdType(1) << 40 })
  {
    vtkNew<vtkDirectionField> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(PolyMeshes::Make(points, { { 0, 1, base + 2 } }));
    filter->Update();
    CHECK(messages->IsOneError({ std::to_string(base + 2).c_str() }));
    CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  }
}

/// Points in float and double at places that both can tell: the same field, in their own type.
void TestPrecision()
{
  auto single = PolyMeshes::Pebble(2, VTK_FLOAT);
  auto twice = PolyMeshes::Pebble(2);
  for (vtkIdType i = 0; i < single->GetNumberOfPoints(); ++i)
  {
    twice->GetPoints()->SetPoint(i, single->GetPoint(i));
  }
  auto one = FieldOf(single);
  auto other = FieldOf(twice);
  CHECK(vtkFloatArray::SafeDownCast(Direction(one, 0)) != nullptr);
  CHECK(vtkDoubleArray::SafeDownCast(Direction(other, 0)) != nullptr);
  CHECK(FieldValue(one, "Eigenvalue") == FieldValue(other, "Eigenvalue"));
  CHECK(IsSame(one->GetCellData(), other->GetCellData()));
  bool same = true;
  for (int k = 0; k < 4; ++k)
  {
    for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        same = same &&
          static_cast<float>(Direction(other, k)->GetComponent(i, c)) ==
            static_cast<float>(Direction(one, k)->GetComponent(i, c));
      }
    }
  }
  CHECK(same);
}

/// Filters of several threads that run at the same time, on inputs of their own and on a shared one.
void TestThreads()
{
  auto shared = PolyMeshes::Pebble(3);
  // VTK's data sets make some of their data when first asked.
  shared->BuildCells();
  std::vector<PolyMeshes::Mesh> own;
  std::vector<vtkSmartPointer<vtkPolyData>> expected, results;
  constexpr int threads = 4;
  for (int k = 0; k < threads; ++k)
  {
    own.push_back(k % 2 == 0 ? PolyMeshes::QuadTorus(30, 12 + k) : shared);
    expected.push_back(FieldOf(own.back(), 2 + k));
  }
  results.resize(threads);
  std::vector<std::thread> running;
  for (int k = 0; k < threads; ++k)
  {
    running.emplace_back(
      [&, k]
      {
        for (int repetition = 0; repetition < 3; ++repetition)
        {
          results[k] = FieldOf(own[k], 2 + k);
        }
      });
  }
  for (std::thread& thread : running)
  {
    thread.join();
  }
  for (int k = 0; k < threads; ++k)
  {
    CheckSame(results[k], expected[k]);
  }
}
}

int TestDirectionFieldStorage(int, char*[])
{
  TestCellArrays();
  TestLargeIds();
  TestPrecision();
  TestThreads();
  return Result();
}
