// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers of the output on surfaces for which they are known.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkIntArray.h"

using namespace Checks;

namespace
{
/// On a closed surface the sums of the indices, the directions and the second output are right.
void TestClosed(vtkPolyData* mesh, int degree, int euler)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->Update();
  CHECK(messages->IsEmpty());

  vtkPolyData* field = filter->GetOutput();
  CHECK(field->GetNumberOfPoints() == mesh->GetNumberOfPoints());
  CHECK(field->GetNumberOfCells() == mesh->GetNumberOfCells());
  CHECK(SumOfIndices(field->GetCellData()) == degree * euler);
  CHECK(FieldValue(field, "IndexSum") == degree * euler);
  CHECK(FieldValue(field, "EulerCharacteristic") == euler);
  CHECK(FieldValue(field, "Eigenvalue") >= 0.0);
  CHECK(FieldValue(field, "Residual") <= filter->GetTolerance());
  CHECK(FieldValue(field, "Iterations") >= 0);
  for (const char* name : { "IndexSum", "EulerCharacteristic", "Iterations" })
  {
    CHECK(vtkIntArray::SafeDownCast(field->GetFieldData()->GetArray(name)));
  }
  for (const char* name : { "Eigenvalue", "Residual" })
  {
    CHECK(field->GetFieldData()->GetArray(name)->GetDataType() == VTK_DOUBLE);
  }

  vtkDataArray* index = field->GetCellData()->GetArray("SingularityIndex");
  REQUIRE(index && index->GetDataType() == VTK_INT);
  REQUIRE(index->GetNumberOfTuples() == field->GetNumberOfCells());
  vtkPolyData* singularities = filter->GetOutput(1);
  vtkPointData* data = singularities->GetPointData();
  CHECK(singularities->GetNumberOfVerts() == singularities->GetNumberOfPoints());
  CHECK(singularities->GetNumberOfCells() == singularities->GetNumberOfPoints());
  CHECK(euler == 0 || singularities->GetNumberOfPoints() > 0);
  CHECK(SumOfIndices(data) == degree * euler);
  vtkDataArray* singularIndex = data->GetArray("SingularityIndex");
  vtkDataArray* fraction = data->GetArray("Index");
  vtkDataArray* cells = data->GetArray("CellId");
  vtkDataArray* normals = data->GetNormals();
  REQUIRE(singularIndex && fraction && cells && normals);
  CHECK(singularIndex->GetDataType() == VTK_INT);
  CHECK(fraction->GetDataType() == VTK_DOUBLE);
  CHECK(cells->GetDataType() == VTK_ID_TYPE);
  CHECK(normals->GetDataType() == VTK_FLOAT && std::string(normals->GetName()) == "Normals");

  std::vector<double> sums(static_cast<size_t>(field->GetNumberOfCells()), 0.0);
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetTuple1(i));
    REQUIRE(cell >= 0 && cell < field->GetNumberOfCells());
    sums[static_cast<size_t>(cell)] += singularIndex->GetTuple1(i);
    CHECK(singularIndex->GetTuple1(i) != 0.0);
    CHECK(fraction->GetTuple1(i) == singularIndex->GetTuple1(i) / degree);
    CHECK(std::abs(vtkMath::Norm(normals->GetTuple3(i)) - 1.0) < 1e-6);
    double bounds[6], point[3];
    field->GetCellBounds(cell, bounds);
    singularities->GetPoint(i, point);
    for (int c = 0; c < 3; ++c)
    {
      CHECK(point[c] >= bounds[2 * c] - 1e-6 && point[c] <= bounds[2 * c + 1] + 1e-6);
    }
  }
  for (vtkIdType cell = 0; cell < field->GetNumberOfCells(); ++cell)
  {
    CHECK(sums[static_cast<size_t>(cell)] == index->GetTuple1(cell));
  }
}

/// At a vertex of a sphere the normal of a singularity points outwards and its point is the
/// centroid of its triangle.
void TestSingularitiesOnSphere()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Icosphere(2));
  filter->Update();
  vtkPolyData* singularities = filter->GetOutput(1);
  CHECK(singularities->GetNumberOfPoints() == 8);
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    double point[3], centroid[3] = { 0.0, 0.0, 0.0 };
    singularities->GetPoint(i, point);
    vtkNew<vtkIdList> ids;
    filter->GetOutput()->GetCellPoints(
      static_cast<vtkIdType>(singularities->GetPointData()->GetArray("CellId")->GetTuple1(i)), ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      double corner[3];
      filter->GetOutput()->GetPoint(ids->GetId(k), corner);
      vtkMath::Add(centroid, corner, centroid);
    }
    vtkMath::MultiplyScalar(centroid, 1.0 / 3.0);
    CHECK(vtkMath::Distance2BetweenPoints(point, centroid) < 1e-20);
    vtkMath::Normalize(point);
    CHECK(vtkMath::Dot(point, singularities->GetPointData()->GetNormals()->GetTuple3(i)) > 0.99);
  }
}

void TestDirections(int degree, int precision)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Pebble(2, precision));
  filter->SetDegree(degree);
  filter->Update();
  vtkPolyData* field = filter->GetOutput();
  CheckDirections(field, degree, precision == VTK_DOUBLE ? 1e-12 : 1e-6);
  CHECK(Direction(field, 0)->GetDataType() == precision);
  vtkDataArray* magnitude = field->GetPointData()->GetArray("RepresentationMagnitude");
  REQUIRE(magnitude);
  CHECK(magnitude->GetDataType() == precision);
  CHECK(magnitude->GetNumberOfTuples() == field->GetNumberOfPoints());
  double range[2];
  magnitude->GetRange(range);
  CHECK(range[0] >= 0.0 && range[1] > 0.0 && range[1] < 10.0);
  CHECK(filter->GetOutput(1)->GetPoints()->GetDataType() == precision);
}

/// The eigenvalue of the smoothest field of a unit sphere is n (1 - s).
void TestEigenvalue()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Icosphere(4));
  for (const double bias : { -1.0, 0.0, 0.5 })
  {
    filter->SetEnergyBias(bias);
    filter->Update();
    const double expected = 4.0 * (1.0 - bias);
    CHECK(std::abs(FieldValue(filter->GetOutput(), "Eigenvalue") - expected) < 0.02 * expected);
  }
}

/// A flat square has a constant field, also with points that are neither float nor double.
void TestFlat()
{
  for (const int precision : { VTK_DOUBLE, VTK_FLOAT, VTK_INT })
  {
    auto mesh = PolyMeshes::Square(5);
    vtkNew<vtkPoints> points;
    points->SetDataType(precision);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      // The coordinates are whole numbers, because some points are integer.
      points->InsertNextPoint(std::round(5.0 * p[0]), std::round(5.0 * p[1]), 0.0);
    }
    mesh->SetPoints(points);
    vtkNew<vtkDirectionField> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(mesh);
    filter->Update();
    CHECK(messages->IsEmpty());
    vtkPolyData* field = filter->GetOutput();
    CheckDirections(field, 4, 1e-6);
    CHECK(Direction(field, 0)->GetDataType() == (precision == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT));
    CHECK(std::abs(FieldValue(field, "Eigenvalue")) < 1e-9);
    CHECK(FieldValue(field, "EulerCharacteristic") == 1);
    CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
    double first[3];
    Direction(field, 0)->GetTuple(0, first);
    for (vtkIdType i = 1; i < field->GetNumberOfPoints(); ++i)
    {
      double best = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        best = std::max(best, vtkMath::Dot(first, Direction(field, k)->GetTuple3(i)));
      }
      CHECK(best > 1.0 - 1e-6);
    }
  }
}

/// Two components have two tuples of figures, and on each of them is the field that it has alone.
void TestTwoComponents()
{
  auto pebble = PolyMeshes::Pebble(2);
  auto torus = PolyMeshes::QuadTorus(24, 12);
  vtkNew<vtkDirectionField> both, alone;
  both->SetInputData(PolyMeshes::BesideEachOther(pebble, torus, 5.0));
  both->Update();
  vtkPolyData* field = both->GetOutput();
  for (const char* name :
    { "Eigenvalue", "Residual", "Iterations", "EulerCharacteristic", "IndexSum" })
  {
    REQUIRE(field->GetFieldData()->GetArray(name));
    CHECK(field->GetFieldData()->GetArray(name)->GetNumberOfTuples() == 2);
    CHECK(field->GetFieldData()->GetArray(name)->GetNumberOfComponents() == 1);
  }
  CHECK(FieldValue(field, "EulerCharacteristic", 0) == 2);
  CHECK(FieldValue(field, "EulerCharacteristic", 1) == 0);
  CHECK(FieldValue(field, "IndexSum", 0) == 8);
  CHECK(FieldValue(field, "IndexSum", 1) == 0);
  vtkIdType component = 0;
  for (vtkPolyData* mesh : { pebble.Get(), torus.Get() })
  {
    alone->SetInputData(mesh);
    alone->Update();
    const double eigenvalue = FieldValue(alone->GetOutput(), "Eigenvalue");
    CHECK(std::abs(FieldValue(field, "Eigenvalue", component) - eigenvalue) < 1e-6 * eigenvalue);
    ++component;
  }
}

/// Points without triangles get zero vectors.
void TestUnusedPoints()
{
  auto mesh = PolyMeshes::Icosphere(1);
  const vtkIdType used = mesh->GetNumberOfPoints();
  mesh->GetPoints()->InsertNextPoint(3.0, 4.0, 5.0);
  mesh->GetPoints()->InsertNextPoint(std::nan(""), 0.0, 0.0);
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  filter->Update();
  CHECK(messages->IsEmpty());
  vtkPolyData* field = filter->GetOutput();
  REQUIRE(field->GetNumberOfPoints() == used + 2);
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const double length = vtkMath::Norm(Direction(field, k)->GetTuple3(i));
      CHECK(i < used ? std::abs(length - 1.0) < 1e-12 : length == 0.0);
    }
    const double u = field->GetPointData()->GetArray("RepresentationMagnitude")->GetTuple1(i);
    CHECK(i < used ? u > 0.0 : u == 0.0);
  }
}
}

int TestDirectionFieldNumbers(int, char*[])
{
  for (const int degree : { 1, 2, 3, 4, 5, 6, 16 })
  {
    TestClosed(PolyMeshes::Icosphere(2), degree, 2);
    TestClosed(PolyMeshes::QuadTorus(20, 10), degree, 0);
    TestClosed(PolyMeshes::QuadCube(), degree, 2);
  }
  TestSingularitiesOnSphere();
  for (const int degree : { 1, 2, 3, 4, 6, 16 })
  {
    TestDirections(degree, VTK_DOUBLE);
    TestDirections(degree, VTK_FLOAT);
  }
  TestEigenvalue();
  TestFlat();
  TestTwoComponents();
  TestUnusedPoints();
  return Result();
}
