// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields along tensors: how the array is read, which arrays there are, and the texts of the messages.

#include "Checks.h"
#include "Meshes/PolyData.h"
#include "Meshes/TensorFields.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldStreamlines.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>

using namespace Checks;

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

const char* const TensorArrays[] = { "MajorValue", "MinorValue", "TensorAnisotropy",
  "SurfaceTensor" };

/// Adds tensors of 6 or 9 components.
template <typename ArrayT>
void AddTensors(const DirectionFields::SurfaceTensors& tensors, int components, const char* name,
  vtkPolyData* mesh)
{
  constexpr int order[] = { 0, 3, 5, 3, 1, 4, 5, 4, 2 };
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  const auto tuples = static_cast<vtkIdType>(tensors.Values.size() / 6);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, tensors.Values[6 * i + (components == 6 ? c : order[c])]);
    }
  }
  if (tensors.AtTriangles)
  {
    mesh->GetCellData()->AddArray(array);
  }
  else
  {
    mesh->GetPointData()->AddArray(array);
  }
}

Mesh StressedPlate(int precision = VTK_DOUBLE)
{
  const DirectionFields::Surface plate = Meshes::Plate(80, 20);
  Mesh mesh = Meshes::ToPolyData(plate, precision);
  const auto points = Meshes::AtPoints(plate, Meshes::Kirsch);
  AddTensors<vtkDoubleArray>(points, 6, "Stress", mesh);
  AddTensors<vtkFloatArray>(points, 9, "Stress9", mesh);
  AddTensors<vtkFloatArray>(Meshes::AtTriangles(plate, Meshes::Kirsch), 6, "Stress", mesh);
  return mesh;
}

vtkSmartPointer<vtkDirectionField> FilterOf(vtkPolyData* mesh, int degree,
  const char* name = "Stress", int association = vtkDataObject::FIELD_ASSOCIATION_POINTS)
{
  auto filter = vtkSmartPointer<vtkDirectionField>::New();
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->SetAlignment(vtkDirectionField::ALIGN_TENSOR);
  filter->SetTensorArray(association, name);
  return filter;
}

std::string SummaryOf(vtkDirectionField* filter)
{
  filter->Update();
  auto* const texts =
    vtkStringArray::SafeDownCast(filter->GetOutput()->GetFieldData()->GetAbstractArray("Summary"));
  return texts ? std::string(texts->GetValue(0)) : "";
}

void TestArrays()
{
  for (const int precision : { VTK_FLOAT, VTK_DOUBLE })
  {
    const Mesh mesh = StressedPlate(precision);
    const auto filter = FilterOf(mesh, 2);
    filter->SetTensorScale(0.1);
    filter->Update();
    vtkPointData* const points = filter->GetOutput()->GetPointData();
    for (const char* const name : TensorArrays)
    {
      REQUIRE(points->GetArray(name) != nullptr);
      CHECK(points->GetArray(name)->GetDataType() == precision);
      CHECK(points->GetArray(name)->GetNumberOfTuples() == mesh->GetNumberOfPoints());
    }
    CHECK(std::abs(points->GetArray("MajorValue")->GetRange()[1] - 3.0) < 0.02);
    CHECK(std::abs(points->GetArray("MinorValue")->GetRange()[0] + 1.0) < 0.02);
    CHECK(points->GetArray("SurfaceTensor")->GetNumberOfComponents() == 6);
    vtkDataArray* const given = mesh->GetPointData()->GetArray("Stress");
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 6; ++c)
      {
        CHECK(std::abs(points->GetArray("SurfaceTensor")->GetComponent(i, c) -
                given->GetComponent(i, c)) < 1e-5);
      }
      const double major = points->GetArray("MajorValue")->GetTuple1(i);
      const double minor = points->GetArray("MinorValue")->GetTuple1(i);
      CHECK(std::abs(points->GetArray("TensorAnisotropy")->GetTuple1(i) - 0.5 * (major - minor)) <
        1e-5);
    }
    // They are no constraints, and the next field has none of them.
    CHECK(!points->GetArray("ConstraintKind"));
    vtkNew<vtkDirectionField> next;
    next->SetInputData(filter->GetOutput());
    next->Update();
    for (const char* const name : TensorArrays)
    {
      CHECK(!next->GetOutput()->GetPointData()->GetArray(name));
    }
  }
}

void TestKindsOfArrays()
{
  const Mesh mesh = StressedPlate();
  const auto filter = FilterOf(mesh, 4);
  filter->Update();
  vtkNew<vtkPolyData> points;
  points->DeepCopy(filter->GetOutput());
  filter->SetTensorArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Stress9");
  filter->Update();
  CHECK(LargestAngle(points, filter->GetOutput(), 4) < 0.01);
  filter->SetTensorArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Stress");
  filter->Update();
  double sum = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double least = 90.0;
    for (int k = 0; k < 4; ++k)
    {
      const double cosine = vtkMath::Dot(
        Direction(points, 0)->GetTuple3(i), Direction(filter->GetOutput(), k)->GetTuple3(i));
      least = std::min(least, vtkMath::DegreesFromRadians(std::acos(std::min(1.0, cosine))));
    }
    sum += least * least;
  }
  CHECK(std::sqrt(sum / static_cast<double>(mesh->GetNumberOfPoints())) < 2.0);
  // What changes in place is read again.
  mesh->GetCellData()->GetArray("Stress")->Fill(0.0);
  mesh->GetCellData()->GetArray("Stress")->Modified();
  mesh->Modified();
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->IsOneWarning({ "Choose another Tensor Array" }));
}

void TestPolygons()
{
  // Quads have the tensor of their cell: around the tube of the torus, which is no circle here.
  const Mesh mesh = PolyMeshes::QuadTorus(48, 24);
  DirectionFields::SurfaceTensors tensors;
  tensors.AtTriangles = true;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    mesh->GetCellPoints(cell, corners);
    double a[3];
    double b[3];
    mesh->GetPoint(corners->GetId(0), a);
    mesh->GetPoint(corners->GetId(3), b);
    const DirectionFields::Vector3 side(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const DirectionFields::Vector3 d = side.normalized();
    Meshes::Append(d * d.transpose(), tensors.Values);
  }
  AddTensors<vtkDoubleArray>(tensors, 9, "Fibres", mesh);
  const auto filter = FilterOf(mesh, 2, "Fibres", vtkDataObject::FIELD_ASSOCIATION_CELLS);
  CHECK(SummaryOf(filter).find("no singularities, index sum 0") == 0);
  CHECK(filter->GetOutput()->GetPointData()->GetArray("MajorValue")->GetRange()[0] > 0.9);
}

void TestSummary()
{
  const DirectionFields::Surface square = Meshes::Square(60);
  const Mesh mesh = Meshes::ToPolyData(square);
  const auto tensors = Meshes::AtPoints(
    square, [](const DirectionFields::Vector3& p) { return Meshes::Plane(Meshes::Four(p), 0.2); });
  AddTensors<vtkDoubleArray>(tensors, 6, "Strain", mesh);
  const auto filter = FilterOf(mesh, 2, "Strain");
  const std::string lines = SummaryOf(filter);
  CHECK(lines.find("4 singularities (2 +, 2 -)") == 0);
  CHECK(lines.find(", along Strain: 2 wedges, 2 trisectors, ") != std::string::npos);
  CHECK(lines.find("% isotropic") != std::string::npos);
  filter->SetDegree(4);
  CHECK(SummaryOf(filter).find("wedge") == std::string::npos);
  CHECK(SummaryOf(filter).find(", along Strain: ") != std::string::npos);
  filter->SetAlignment(vtkDirectionField::ALIGN_NONE);
  CHECK(SummaryOf(filter).find("Strain") == std::string::npos);
}

/// The value of Kirsch's stress along a line in the plane.
double ValueAlong(const double place[3], const double along[3])
{
  const DirectionFields::Vector3 p(place[0], place[1], place[2]);
  const DirectionFields::Vector3 d(along[0], along[1], along[2]);
  return d.dot(Meshes::Kirsch(p) * d);
}

void TestLinesAndGlyphs()
{
  const auto filter = FilterOf(StressedPlate(), 4);
  filter->SetTensorScale(0.1);
  vtkNew<vtkDirectionFieldStreamlines> lines;
  lines->SetInputConnection(filter->GetOutputPort());
  lines->SetOffset(0.0);
  lines->Update();
  vtkPointData* const data = lines->GetOutput()->GetPointData();
  vtkDataArray* const values = data->GetArray("PrincipalValue");
  REQUIRE(values != nullptr);
  // Tension and compression.
  CHECK(values->GetRange()[0] < -0.3 && values->GetRange()[1] > 2.0);
  double squares = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    double p[3];
    double d[3];
    lines->GetOutput()->GetPoint(i, p);
    data->GetArray("Direction")->GetTuple(i, d);
    const double off = values->GetTuple1(i) - ValueAlong(p, d);
    squares += off * off;
  }
  CHECK(std::sqrt(squares / static_cast<double>(values->GetNumberOfTuples())) < 0.02);

  vtkNew<vtkDirectionFieldGlyphs> glyphs;
  glyphs->SetInputConnection(filter->GetOutputPort());
  glyphs->SetGlyphMode(vtkDirectionFieldGlyphs::ALL_POINTS);
  glyphs->SetMaximumNumberOfGlyphs(100000);
  glyphs->Update();
  vtkCellData* const cells = glyphs->GetOutput()->GetCellData();
  REQUIRE(cells->GetArray("PrincipalValue") != nullptr);
  for (vtkIdType i = 0; i < glyphs->GetOutput()->GetNumberOfCells(); i += 7)
  {
    double p[3];
    double d[3];
    filter->GetOutput()->GetPoint(
      static_cast<vtkIdType>(cells->GetArray("PointId")->GetTuple1(i)), p);
    cells->GetArray("Direction")->GetTuple(i, d);
    CHECK(std::abs(cells->GetArray("PrincipalValue")->GetTuple1(i) - ValueAlong(p, d)) < 1e-3);
  }
}

void TestError(
  vtkPolyData* mesh, int degree, const char* name, int association, const char* sentence)
{
  const auto filter = FilterOf(mesh, degree, name, association);
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->IsOneError({ sentence }));
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}

void TestErrors()
{
  const Mesh mesh = StressedPlate();
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  constexpr int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Force");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  vectors->Fill(1.0);
  mesh->GetPointData()->AddArray(vectors);
  TestError(mesh, 2, "", points, "there is none.");
  TestError(mesh, 2, nullptr, points, "Choose a point or cell array of 6 or 9 components");
  TestError(mesh, 2, "Stress9", cells, "there is no cell array \"Stress9\".");
  TestError(
    mesh, 2, "Force", points, "has 3 components, for which there is Alignment Point Vectors");
  TestError(mesh, 3, "Stress", points, "Set Directions per point (Degree) to 2 or 4: a tensor");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh->GetPointData()->GetArray("Stress")->SetComponent(13, 2, nan);
  mesh->GetCellData()->GetArray("Stress")->SetComponent(17, 2, nan);
  TestError(mesh, 2, "Stress", points, "that of point 13 is not");
  TestError(mesh, 2, "Stress", cells, "that of cell 17 is not");
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetAlignment(vtkDirectionField::ALIGN_TENSOR);
  filter->SetDegree(2);
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->IsOneError({ "there is none." }));
}

void TestBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, StressedPlate());
  blocks->SetBlock(1, StressedPlate(VTK_FLOAT));
  vtkNew<vtkDirectionField> filter;
  filter->SetInputDataObject(blocks);
  filter->SetDegree(2);
  filter->SetAlignment(vtkDirectionField::ALIGN_TENSOR);
  filter->SetTensorArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Stress");
  filter->Update();
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  REQUIRE(output != nullptr);
  for (unsigned int k = 0; k < 2; ++k)
  {
    auto* const block = vtkPolyData::SafeDownCast(output->GetBlock(k));
    REQUIRE(block != nullptr);
    CHECK(block->GetPointData()->GetArray("MajorValue") != nullptr);
  }
}

/// Cells of other processes are told from the own ones, and change nothing else.
void TestGhostCells()
{
  const Mesh mesh = StressedPlate();
  const auto whole = FilterOf(mesh, 2);
  whole->Update();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfTuples(mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    ghosts->SetValue(i, (i / 7) % 2 == 0 ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  vtkNew<vtkPolyData> piece;
  piece->ShallowCopy(mesh);
  piece->GetCellData()->AddArray(ghosts);
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataObject::FIELD_ASSOCIATION_CELLS })
  {
    whole->SetTensorArray(association, "Stress");
    whole->Update();
    const auto filter = FilterOf(piece, 2, "Stress", association);
    filter->Update();
    CHECK(IsSame(Direction(filter->GetOutput(), 0), Direction(whole->GetOutput(), 0)));
    for (const char* const name : TensorArrays)
    {
      vtkDataArray* const values = filter->GetOutput()->GetPointData()->GetArray(name);
      REQUIRE(values != nullptr);
      CHECK(IsSame(values, whole->GetOutput()->GetPointData()->GetArray(name)));
    }
  }
}

/// Steps of a series whose stress turns by 18 degrees each: the field turns with it, at once.
void TestTimeSteps()
{
  const DirectionFields::Surface plate = Meshes::Plate(40, 10);
  const Mesh mesh = Meshes::ToPolyData(plate, VTK_DOUBLE);
  vtkNew<vtkDirectionField> series;
  series->SetInputData(mesh);
  series->SetDegree(2);
  series->SetAlignment(vtkDirectionField::ALIGN_TENSOR);
  series->SetTensorArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Stress");
  for (int step = 0; step <= 10; ++step)
  {
    const double angle = 0.1 * step * vtkMath::Pi();
    AddTensors<vtkDoubleArray>(Meshes::AtPoints(plate,
                                 [angle](const DirectionFields::Vector3&)
                                 { return Meshes::Plane(std::polar(1.0, 2.0 * angle), 0.5); }),
      6, "Stress", mesh);
    mesh->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step);
    mesh->Modified();
    series->Update();
    vtkDataArray* const directions = Direction(series->GetOutput(), 0);
    double least = 1.0;
    for (vtkIdType i = 0; i < directions->GetNumberOfTuples(); ++i)
    {
      const double* const d = directions->GetTuple3(i);
      least = std::min(least, std::abs(std::cos(angle) * d[0] + std::sin(angle) * d[1]));
    }
    CHECK(least > 1.0 - 1e-9);
  }
}

void TestRanges()
{
  vtkNew<vtkDirectionField> filter;
  CHECK(filter->GetTensorDirection() == vtkDirectionField::MAJOR);
  CHECK(filter->GetTensorStrength() == 1.0);
  CHECK(filter->GetTensorScale() == 0.0);
  filter->SetTensorDirection(3);
  CHECK(filter->GetTensorDirection() == vtkDirectionField::LARGER_MAGNITUDE);
  filter->SetTensorStrength(2.0);
  CHECK(filter->GetTensorStrength() == 1.0);
  filter->SetTensorScale(100.0);
  CHECK(filter->GetTensorScale() == 32.0);
}
}

int TestDirectionFieldTensors(int, char*[])
{
  TestArrays();
  TestKindsOfArrays();
  TestPolygons();
  TestSummary();
  TestLinesAndGlyphs();
  TestErrors();
  TestBlocks();
  TestGhostCells();
  TestTimeSteps();
  TestRanges();
  return Result();
}
