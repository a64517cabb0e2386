// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A field at a glance: the line Summary, and the sizes of the singularities.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace Checks;

namespace
{
std::string SummaryOf(vtkDataObject* data)
{
  auto* texts = vtkStringArray::SafeDownCast(
    data ? data->GetFieldData()->GetAbstractArray("Summary") : nullptr);
  return texts && texts->GetNumberOfValues() == 1 ? std::string(texts->GetValue(0)) : "(none)";
}

/// The line, where both outputs have the same.
std::string Summary(vtkDirectionField* filter)
{
  filter->Update();
  const std::string summary = SummaryOf(filter->GetOutputDataObject(0));
  CHECK(summary == SummaryOf(filter->GetOutputDataObject(1)));
  CHECK(std::all_of(summary.begin(), summary.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  std::cout << summary << std::endl;
  return summary;
}

/// Points without regularity: a rough sphere has singularities of both signs.
PolyMeshes::Mesh RoughSphere(int levels)
{
  auto mesh = PolyMeshes::Icosphere(levels);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    vtkMath::MultiplyScalar(p, 1.0 + 0.25 * std::fmod(0.6180339887 * i, 1.0));
    mesh->GetPoints()->SetPoint(i, p);
  }
  return mesh;
}

/// The square, laid on a disk, with its corners at the boundary of the disk.
PolyMeshes::Mesh Disk(int n)
{
  auto mesh = PolyMeshes::Square(n);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const double x = 2.0 * p[0] - 1.0;
    const double y = 2.0 * p[1] - 1.0;
    mesh->GetPoints()->SetPoint(
      i, x * std::sqrt(1.0 - 0.5 * y * y), y * std::sqrt(1.0 - 0.5 * x * x), 0.0);
  }
  return mesh;
}

std::string Singularities(vtkDirectionField* filter)
{
  filter->Update();
  vtkDataArray* index = filter->GetOutput(1)->GetPointData()->GetArray("SingularityIndex");
  int positive = 0;
  for (vtkIdType i = 0; i < index->GetNumberOfTuples(); ++i)
  {
    positive += index->GetTuple1(i) > 0.0 ? 1 : 0;
  }
  const auto number = static_cast<int>(index->GetNumberOfTuples());
  return std::to_string(number) + " singularities (" + std::to_string(positive) + " +, " +
    std::to_string(number - positive) + " -)";
}

void TestSmoothest()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Icosphere(1));
  CHECK(Summary(filter) == "8 singularities (8 +, 0 -), index sum 8");
  filter->SetInputData(PolyMeshes::Square(5));
  CHECK(Summary(filter) == "no singularities, index sum 0");
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(RoughSphere(4));
  const std::string rough = Summary(filter);
  CHECK(messages->IsOneWarning({ "faded", "Unit Length" }));
  CHECK(rough == Singularities(filter) + ", index sum 8");
  CHECK(rough.find(", 0 -") == std::string::npos);
  // The summary of a filter before is replaced.
  vtkNew<vtkDirectionField> second;
  second->SetInputConnection(filter->GetOutputPort());
  second->SetDegree(1);
  CHECK(Summary(second) == Singularities(second) + ", index sum 2");
  CHECK(SummaryOf(filter->GetOutput()) == rough);
}

void TestSeveralComponents()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::BesideEachOther(
    PolyMeshes::Pebble(2), PolyMeshes::BesideEachOther(RoughSphere(3), RoughSphere(2), 5.0), 5.0));
  CHECK(Summary(filter) == Singularities(filter) + ", index sum 24 over 3 components");
}

/// Components that did not converge are counted, and the residual is given.
void TestNotConverged()
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetSolver(vtkDirectionField::SOLVER_MULTIGRID);
  filter->SetTolerance(1e-12);
  filter->SetMaximumIterations(1);
  filter->SetInputData(RoughSphere(5));
  const std::string one = Summary(filter);
  const auto after = one.find(", index sum 8, not converged (residual ");
  REQUIRE(after != std::string::npos && one.back() == ')');
  const double residual = std::stod(one.substr(one.rfind(' ')));
  const double reached = FieldValue(filter->GetOutput(), "Residual");
  CHECK(reached > 1e-12 && std::abs(residual - reached) < 0.06 * reached);

  filter->SetInputData(PolyMeshes::BesideEachOther(RoughSphere(5), PolyMeshes::Icosphere(0), 5.0));
  CHECK(Summary(filter).find(
          ", index sum 16 over 2 components, 1 of 2 components not converged (residual ") !=
    std::string::npos);
  CHECK(messages->Errors.empty() && messages->Warnings.size() == 2);
}

/// Alignment, constraints and unit length are named where they had an effect.
void TestGuidance()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Pebble(3));
  filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  CHECK(Summary(filter) == Singularities(filter) + ", index sum 8, aligned");
  filter->SetAlignmentStrength(0.0);
  CHECK(Summary(filter).find("aligned") == std::string::npos);

  vtkNew<vtkDirectionField> disk;
  disk->SetInputData(Disk(8));
  disk->SetDegree(1);
  disk->ConstrainBoundaryOn();
  CHECK(Summary(disk) == "1 singularity (1 +, 0 -), index sum 1, 32 points constrained");
  CHECK(disk->GetOutput()->GetPointData()->GetArray("ConstraintKind") != nullptr);
  disk->SetDegree(2);
  disk->UnitLengthOn();
  const std::string unit = Summary(disk);
  vtkDataArray* energy = disk->GetOutput()->GetFieldData()->GetArray("UnitEnergy");
  const double less = 100.0 * (1.0 - energy->GetComponent(0, 1) / energy->GetComponent(0, 0));
  CHECK(unit.find(", 32 points constrained, unit length with " + std::to_string(std::lround(less)) +
          " % less energy") != std::string::npos);
  disk->PreviewOn();
  const std::string preview = Summary(disk);
  const std::string end = ", 32 points constrained, unit length, a preview";
  CHECK(preview.size() > end.size() && preview.substr(preview.size() - end.size()) == end);

  // On a plane the smoothest field has unit length already.
  vtkNew<vtkDirectionField> plane;
  plane->SetInputData(PolyMeshes::Square(4));
  plane->UnitLengthOn();
  CHECK(Summary(plane) == "no singularities, index sum 0, unit length");
}

void TestNothing()
{
  vtkNew<vtkPolyData> points;
  points->SetPoints(PolyMeshes::Square(2)->GetPoints());
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkDirectionField> filter;
  for (vtkPolyData* input : { points.Get(), empty.Get() })
  {
    filter->SetInputData(input);
    CHECK(Summary(filter) == "no field, for there are no triangles");
  }
}

/// Each block has its own line.
void TestComposite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, PolyMeshes::Icosphere(1));
  blocks->SetBlock(2, PolyMeshes::QuadTorus(20, 10));
  vtkNew<vtkDirectionField> filter;
  filter->SetInputDataObject(blocks);
  filter->Update();
  for (const int port : { 0, 1 })
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    REQUIRE(output && output->GetNumberOfBlocks() == 3);
    CHECK(SummaryOf(output->GetBlock(0)).find("8 singularities (8 +, 0 -), index sum 8") == 0);
    CHECK(SummaryOf(output->GetBlock(2)).find(", index sum 0") != std::string::npos);
  }
}

double Diagonal(vtkPolyData* mesh)
{
  double b[6];
  mesh->GetBounds(b);
  return std::sqrt(
    (b[1] - b[0]) * (b[1] - b[0]) + (b[3] - b[2]) * (b[3] - b[2]) + (b[5] - b[4]) * (b[5] - b[4]));
}

double Area(vtkPolyData* mesh)
{
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    mesh->GetCellPoints(t, ids);
    double p[3][3];
    for (int c = 0; c < 3; ++c)
    {
      mesh->GetPoint(ids->GetId(c), p[c]);
    }
    area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  }
  return area;
}

/// Every size is that of index 1 times the index.
/// @return the largest |index|
int CheckSizes(vtkDirectionField* filter, double ofIndexOne)
{
  filter->Update();
  vtkPointData* data = filter->GetOutput(1)->GetPointData();
  vtkDataArray* size = data->GetArray("Size");
  vtkDataArray* index = data->GetArray("SingularityIndex");
  CHECK(size && size->GetDataType() == VTK_FLOAT && size->GetNumberOfComponents() == 1);
  double largest = 0.0;
  for (vtkIdType i = 0; size && i < size->GetNumberOfTuples(); ++i)
  {
    const double times = std::abs(index->GetTuple1(i));
    CHECK(std::abs(size->GetTuple1(i) - times * ofIndexOne) <= 1e-6 * times * ofIndexOne);
    largest = std::max(largest, times);
  }
  CHECK(size && size->GetNumberOfTuples() == filter->GetOutput(1)->GetNumberOfPoints());
  return static_cast<int>(largest);
}

/// Few singularities have the size that the surface asks for, times their index.
void TestSizeOfFew()
{
  vtkNew<vtkDirectionField> filter;
  for (const double unit : { 1.0, 1e-9, 1e9 })
  {
    auto sphere = PolyMeshes::Icosphere(2);
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      double p[3];
      sphere->GetPoint(i, p);
      vtkMath::MultiplyScalar(p, unit);
      sphere->GetPoints()->SetPoint(i, p);
    }
    filter->SetInputData(sphere);
    CHECK(CheckSizes(filter, 0.022 * Diagonal(sphere)) == 1);
  }
  // A tetrahedron has four singularities of index 2 of a hex field.
  auto tetrahedron = PolyMeshes::Make({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } });
  filter->SetInputData(tetrahedron);
  filter->SetDegree(6);
  CHECK(CheckSizes(filter, 0.022 * std::sqrt(12.0)) > 1);
}

/// Cells of another piece count neither in the box nor in the area.
void TestSizeOfPiece()
{
  auto piece = PolyMeshes::Icosphere(2);
  auto both = PolyMeshes::BesideEachOther(piece, PolyMeshes::Icosphere(2), 100.0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(both->GetNumberOfCells());
  for (vtkIdType t = 0; t < both->GetNumberOfCells(); ++t)
  {
    ghosts->SetValue(t, t < piece->GetNumberOfCells() ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  both->GetCellData()->AddArray(ghosts);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(both);
  CHECK(CheckSizes(filter, 0.022 * Diagonal(piece)) == 1);
  CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 8);
  CHECK(Summary(filter).find("8 singularities (8 +, 0 -), index sum 8") == 0);
}

/// Many singularities are smaller, so that they cover an eighth of the surface.
void TestSizeOfMany()
{
  auto sphere = PolyMeshes::Icosphere(4);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("noise");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    vectors->InsertNextTuple3(
      std::sin(37.0 * i), std::sin(101.0 * i + 1.0), std::sin(59.0 * i + 2.0));
  }
  sphere->GetPointData()->AddArray(vectors);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(sphere);
  filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
  filter->SetGuidanceVectors("noise");
  filter->SetAlignmentStrength(1.0);
  filter->Update();
  const auto number = static_cast<double>(filter->GetOutput(1)->GetNumberOfPoints());
  CHECK(number > 400.0);
  const double size = 0.4 * std::sqrt(Area(sphere) / number);
  CHECK(size < 0.022 * Diagonal(sphere));
  CheckSizes(filter, size);
}
}

int TestDirectionFieldSummary(int, char*[])
{
  TestSmoothest();
  TestSeveralComponents();
  TestNotConverged();
  TestGuidance();
  TestNothing();
  TestComposite();
  TestSizeOfFew();
  TestSizeOfPiece();
  TestSizeOfMany();
  return Result();
}
