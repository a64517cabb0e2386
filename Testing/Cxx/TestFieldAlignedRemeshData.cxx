// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data of points and cells on the remesher's mesh: interpolated, mean, not mixed, with their
// integrals.

#include "Checks.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"

#include "vtkFieldAlignedRemesh.h"

#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

using namespace Checks;

namespace
{
template <typename ArrayT>
ArrayT* Add(vtkDataSetAttributes* data, const char* name, int components, vtkIdType tuples,
  const std::function<double(vtkIdType, int)>& value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, value(i, c));
    }
  }
  data->AddArray(array);
  return array;
}

/// The area of a cell; of a quad that of the triangles beside its first diagonal.
double AreaOf(vtkCell* cell)
{
  double p[4][3];
  for (int k = 0; k < cell->GetNumberOfPoints(); ++k)
  {
    cell->GetPoints()->GetPoint(k, p[k]);
  }
  const auto area = [&](int i, int j, int k)
  { return vtkTriangle::TriangleArea(p[i], p[j], p[k]); };
  return area(0, 1, 2) + (cell->GetNumberOfPoints() == 4 ? area(0, 2, 3) : 0.0);
}

/// The sum of value times area, and of its size.
std::pair<double, double> Integral(vtkPolyData* mesh, const char* name, int component)
{
  vtkDataArray* const array = mesh->GetCellData()->GetArray(name);
  double sum = 0.0;
  double size = 0.0;
  for (vtkIdType f = 0; array && f < mesh->GetNumberOfCells(); ++f)
  {
    const double part = AreaOf(mesh->GetCell(f)) * array->GetComponent(f, component);
    sum += part;
    size += std::abs(part);
  }
  return { sum, size };
}

/// Linear functions and vectors are exact on a plane, colors between those of the corners, numbers
/// those of a corner.
void TestPoints()
{
  auto plane = Meshes::ToPolyData(Meshes::Square(8));
  vtkNew<vtkPoints> tilted;
  tilted->SetDataTypeToDouble();
  const vtkIdType count = plane->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* const p = plane->GetPoint(i);
    tilted->InsertNextPoint(p[0], p[1], 0.5 * p[0] - 0.25 * p[1] + 3.0);
  }
  plane->SetPoints(tilted);
  const auto linear = [](const double* p, int c)
  { return (c + 1.0) * p[0] - 2.0 * p[1] + 0.5 * c * p[2] - 1.0; };
  vtkPointData* const data = plane->GetPointData();
  Add<vtkDoubleArray>(
    data, "Vector", 3, count, [&](vtkIdType i, int c) { return linear(plane->GetPoint(i), c); });
  vtkIntArray* const ids =
    Add<vtkIntArray>(data, "Id", 1, count, [](vtkIdType i, int) { return i % 2 == 0 ? 1.0 : 9.0; });
  data->SetScalars(ids);
  Add<vtkUnsignedCharArray>(data, "Color", 3, count,
    [&](vtkIdType i, int c) { return c == 0 ? 200.0 * plane->GetPoint(i)[0] : 7.0; });

  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(plane);
  filter->SetNumberOfFaces(150);
  filter->Update();
  vtkPolyData* const mesh = filter->GetOutput();
  vtkDataArray* const vectors = mesh->GetPointData()->GetArray("Vector");
  vtkDataArray* const carried = mesh->GetPointData()->GetArray("Id");
  vtkDataArray* const colors = mesh->GetPointData()->GetArray("Color");
  REQUIRE(vectors && carried && colors && mesh->GetNumberOfPoints() > 100);
  CHECK(mesh->GetPointData()->GetScalars() == carried);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* const p = mesh->GetPoint(i);
    for (int c = 0; c < 3; ++c)
    {
      CHECK(std::abs(vectors->GetComponent(i, c) - linear(p, c)) < 1e-12);
    }
    CHECK(carried->GetTuple1(i) == 1.0 || carried->GetTuple1(i) == 9.0);
    CHECK(std::abs(colors->GetComponent(i, 0) - 200.0 * p[0]) <= 2.0);
    CHECK(colors->GetComponent(i, 2) == 7.0);
  }
  CHECK(carried->GetRange()[0] == 1.0 && carried->GetRange()[1] == 9.0);
}

constexpr long long LargeId = 1LL << 53;

vtkSmartPointer<vtkPolyData> BodyWithData()
{
  auto body = Meshes::ToPolyData(Meshes::Potato(4));
  const vtkIdType cells = body->GetNumberOfCells();
  vtkCellData* const data = body->GetCellData();
  const auto middle = [&](vtkIdType f, int axis)
  {
    double bounds[6];
    body->GetCell(f)->GetBounds(bounds);
    return 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  };
  // A peak, and a vector that points everywhere.
  Add<vtkFloatArray>(data, "Load", 4, cells,
    [&](vtkIdType f, int c) { return c == 3 ? std::exp(9.0 * middle(f, 0)) : middle(f, c); });
  Add<vtkFloatArray>(data, "One", 1, cells, [](vtkIdType, int) { return 0.1; });
  Add<vtkIntArray>(
    data, "Part", 1, cells, [&](vtkIdType f, int) { return middle(f, 2) > 0.0 ? 1.0 : 100.0; });
  vtkNew<vtkStringArray> name;
  name->SetName("Name");
  for (vtkIdType f = 0; f < cells; ++f)
  {
    name->InsertNextValue(middle(f, 2) > 0.0 ? "top" : "bottom");
  }
  data->AddArray(name);
  // Not both are doubles.
  vtkNew<vtkLongLongArray> large;
  large->SetName("Large");
  for (vtkIdType f = 0; f < cells; ++f)
  {
    large->InsertNextValue(middle(f, 2) > 0.0 ? LargeId : LargeId + 1);
  }
  data->AddArray(large);
  return body;
}

/// Numbers and names are of one of the cells and go together, means of a constant are constant, and
/// the integral is kept where that is asked for.
void TestCells()
{
  const auto body = BodyWithData();
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(body);
  filter->SetNumberOfFaces(200);
  filter->Update();
  CHECK(vtkFloatArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("Load")));
  for (int c = 0; c < 4; ++c)
  {
    const auto given = Integral(body, "Load", c);
    CHECK(
      std::abs(Integral(filter->GetOutput(), "Load", c).first - given.first) > 1e-6 * given.second);
  }
  filter->SetConservedArray("Load");
  filter->Update();
  vtkPolyData* const mesh = filter->GetOutput();
  CHECK(mesh->GetPoints()->GetDataType() == VTK_DOUBLE);
  for (int c = 0; c < 4; ++c)
  {
    const auto given = Integral(body, "Load", c);
    CHECK(std::abs(Integral(mesh, "Load", c).first - given.first) < 1e-12 * given.second);
  }
  vtkDataArray* const one = mesh->GetCellData()->GetArray("One");
  vtkDataArray* const part = mesh->GetCellData()->GetArray("Part");
  auto* const name = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("Name"));
  auto* const large = vtkLongLongArray::SafeDownCast(mesh->GetCellData()->GetArray("Large"));
  REQUIRE(one && part && name && large);
  for (vtkIdType f = 0; f < mesh->GetNumberOfCells(); ++f)
  {
    CHECK(one->GetTuple1(f) == static_cast<double>(0.1f));
    CHECK(part->GetTuple1(f) == (name->GetValue(f) == "top" ? 1.0 : 100.0));
    CHECK(large->GetValue(f) == (name->GetValue(f) == "top" ? LargeId : LargeId + 1));
  }
  CHECK(part->GetRange()[0] == 1.0 && part->GetRange()[1] == 100.0);
}

/// The integral is that over the faces of the output also where its points are single precision.
void TestFloats()
{
  const auto body = BodyWithData();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_FLOAT);
  points->DeepCopy(body->GetPoints());
  body->SetPoints(points);
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(body);
  filter->SetConservedArray("Load");
  std::set<vtkIdType> remainders;
  for (const int faces : { 200, 220, 240, 260, 280, 300 })
  {
    filter->SetNumberOfFaces(faces);
    filter->Update();
    vtkPolyData* const mesh = filter->GetOutput();
    CHECK(mesh->GetPoints()->GetDataType() == VTK_FLOAT);
    remainders.insert(mesh->GetNumberOfPoints() % 4);
    for (int c = 0; c < 4; ++c)
    {
      const auto given = Integral(body, "Load", c);
      CHECK(std::abs(Integral(mesh, "Load", c).first - given.first) < 1e-13 * given.second);
    }
  }
  // Numbers of points that vectors of four do not take whole are among them.
  CHECK(remainders.size() > 1);
}

void TestErrors()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  const auto body = BodyWithData();
  const vtkIdType cells = body->GetNumberOfCells();
  vtkCellData* const data = body->GetCellData();
  const auto one = [](vtkIdType, int) { return 1.0; };
  data->SetNormals(Add<vtkFloatArray>(data, "Normals", 3, cells, one));
  Add<vtkIntArray>(data, "SingularityIndex", 1, cells, one);
  Add<vtkFloatArray>(data, "Direction0", 3, cells, one);
  filter->SetInputData(body);
  filter->SetNumberOfFaces(100);
  filter->SetRegionArray("Part");
  std::size_t errors = 0;
  for (const char* name :
    { "Nothing", "Name", "Part", "Normals", "SingularityIndex", "Direction0" })
  {
    filter->SetConservedArray(name);
    filter->Update();
    CHECK(messages->Errors.size() == ++errors);
    CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  }
  filter->SetConservedArray("None");
  filter->Update();
  CHECK(messages->Errors.size() == errors && filter->GetOutput()->GetNumberOfCells() > 50);
}

/// Other data on the same surface come on the same mesh, which is not made again.
void TestTimeSeries()
{
  const auto body = BodyWithData();
  vtkNew<vtkFieldAlignedRemesh> filter;
  filter->SetInputData(body);
  filter->SetNumberOfFaces(200);
  std::set<std::string> steps;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&steps);
  listener->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      const char* const text = static_cast<vtkAlgorithm*>(caller)->GetProgressText();
      static_cast<std::set<std::string>*>(data)->insert(text ? text : "");
    });
  filter->AddObserver(vtkCommand::ProgressEvent, listener);
  filter->Update();
  CHECK(steps.count("Mapping the surface to a grid") == 1);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(filter->GetOutput());

  steps.clear();
  vtkNew<vtkPolyData> later;
  later->ShallowCopy(body);
  Add<vtkFloatArray>(
    later->GetCellData(), "One", 1, body->GetNumberOfCells(), [](vtkIdType, int) { return 0.25; });
  filter->SetInputData(later);
  filter->Update();
  CHECK(steps.count("Mapping the surface to a grid") == 0);
  vtkPolyData* const mesh = filter->GetOutput();
  CHECK(mesh->GetCellData()->GetArray("One")->GetRange()[0] == 0.25);
  REQUIRE(mesh->GetNumberOfPoints() == before->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    before->GetPoint(i, p);
    CHECK(std::equal(p, p + 3, mesh->GetPoint(i)));
  }

  filter->SetNumberOfFaces(300);
  filter->Update();
  CHECK(steps.count("Mapping the surface to a grid") == 1);
  CHECK(mesh->GetNumberOfPoints() != before->GetNumberOfPoints());
}

/// The segments of a slice are one curve, whatever they measure; those of other numbers are others.
void TestSegments()
{
  constexpr int sides = 48;
  for (const int parts : { 1, 2 })
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkIntArray> part;
    part->SetName("Part");
    vtkNew<vtkDoubleArray> stress;
    stress->SetName("Stress");
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * k / sides;
      points->InsertNextPoint(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle), 0.0);
      // In another order, and each the other way than the one before it.
      const vtkIdType from = 7 * k % sides;
      const vtkIdType ends[] = { (from + k % 2) % sides, (from + 1 - k % 2) % sides };
      lines->InsertNextCell(2, ends);
      part->InsertNextValue(5 + parts * static_cast<int>(from) / sides);
      stress->InsertNextValue(0.1 * k);
    }
    vtkNew<vtkPolyData> slice;
    slice->SetPoints(points);
    slice->SetLines(lines);
    slice->GetCellData()->AddArray(part);
    slice->GetCellData()->AddArray(stress);
    vtkNew<vtkFieldAlignedRemesh> filter;
    filter->SetInputData(Meshes::ToPolyData(Meshes::Square(24)));
    filter->SetNumberOfFaces(900);
    filter->SetCurvesData(slice);
    filter->Update();
    vtkCellData* const found = filter->GetOutput(2)->GetCellData();
    REQUIRE(filter->GetOutput(2)->GetNumberOfCells() == 4 + parts);
    auto* const names = vtkStringArray::SafeDownCast(found->GetAbstractArray("ChainName"));
    double length = 0.0;
    for (int k = 0; k < parts; ++k)
    {
      CHECK(names->GetValue(4 + k) == "Curve " + std::to_string(k) + " 1");
      CHECK(found->GetArray("CurveId")->GetTuple1(4 + k) == k);
      CHECK(found->GetArray("Part")->GetTuple1(4 + k) == 5 + k);
      vtkPoints* const on = filter->GetOutput(2)->GetCell(4 + k)->GetPoints();
      for (vtkIdType i = 1; i < on->GetNumberOfPoints(); ++i)
      {
        std::array<double, 3> a;
        on->GetPoint(i - 1, a.data());
        length += std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), on->GetPoint(i)));
      }
    }
    CHECK(std::abs(length - 0.6 * vtkMath::Pi()) < 0.02);
  }
}
}

int TestFieldAlignedRemeshData(int, char*[])
{
  TestPoints();
  TestCells();
  TestFloats();
  TestErrors();
  TestTimeSeries();
  TestSegments();
  return Result();
}
