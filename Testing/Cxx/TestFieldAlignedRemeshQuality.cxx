// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The quality of the remesher's faces beside that of vtkMeshQuality, and the limits of it.

#include "Checks.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"

#include "vtkFieldAlignedRemesh.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkMeshQuality.h"
#include "vtkSignedCharArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace Checks;

namespace
{
double Number(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* array = mesh->GetFieldData()->GetArray(name);
  return array ? array->GetTuple1(0) : std::nan("");
}

std::string SummaryOf(vtkPolyData* mesh)
{
  return vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("Summary"))
    ->GetValue(0);
}

/// What vtkMeshQuality gives for each face.
/// @param measures chooses the measures of quads and triangles
vtkSmartPointer<vtkDataArray> Measured(
  vtkPolyData* mesh, const std::function<void(vtkMeshQuality*)>& measures)
{
  vtkNew<vtkMeshQuality> quality;
  quality->SetInputData(mesh);
  measures(quality);
  quality->Update();
  return quality->GetOutput()->GetCellData()->GetArray("Quality");
}

/// The largest difference of an array from what it should be, over the larger one of that and 1.
double Difference(
  vtkPolyData* mesh, const char* name, const std::function<double(vtkIdType)>& expected)
{
  vtkDataArray* const array = mesh->GetCellData()->GetArray(name);
  CHECK(array != nullptr);
  double largest = 0.0;
  for (vtkIdType f = 0; array && f < mesh->GetNumberOfCells(); ++f)
  {
    const double value = expected(f);
    largest =
      std::max(largest, std::abs(array->GetTuple1(f) - value) / std::max(1.0, std::abs(value)));
  }
  return largest;
}

/// On quads, triangles and both, on bent and flat surfaces, without smoothing, too.
void TestIsThatOfMeshQuality()
{
  struct Case
  {
    DirectionFields::Surface Given;
    int Element;
    int Smoothing;
    bool IsPure;
  };
  for (const Case& at : { Case{ Meshes::Potato(3), 0, 12, false },
         Case{ Meshes::Potato(3), 0, 0, true }, Case{ Meshes::Potato(3), 1, 12, false },
         Case{ Meshes::Square(8), 0, 12, false }, Case{ Meshes::Cube(), 0, 0, false } })
  {
    vtkNew<vtkFieldAlignedRemesh> filter;
    filter->SetInputData(Meshes::ToPolyData(at.Given));
    filter->SetNumberOfFaces(300);
    filter->SetElement(at.Element);
    filter->SetSmoothingIterations(at.Smoothing);
    filter->SetPureQuads(at.IsPure);
    filter->Update();
    vtkPolyData* const mesh = filter->GetOutput();
    CHECK(mesh->GetNumberOfCells() > 100);
    const auto jacobians = Measured(mesh,
      [](vtkMeshQuality* quality)
      {
        quality->SetQuadQualityMeasureToScaledJacobian();
        quality->SetTriangleQualityMeasureToScaledJacobian();
      });
    const auto ratios = Measured(mesh,
      [](vtkMeshQuality* quality)
      {
        quality->SetQuadQualityMeasureToAspectRatio();
        quality->SetTriangleQualityMeasureToAspectRatio();
      });
    const auto cubes =
      Measured(mesh, [](vtkMeshQuality* quality) { quality->SetQuadQualityMeasureToWarpage(); });
    REQUIRE(jacobians && ratios && cubes);
    CHECK(Difference(mesh, "ScaledJacobian", [&](vtkIdType f) { return jacobians->GetTuple1(f); }) <
      1e-6);
    CHECK(
      Difference(mesh, "AspectRatio", [&](vtkIdType f) { return ratios->GetTuple1(f); }) < 1e-6);
    CHECK(Difference(mesh, "Warpage",
            [&](vtkIdType f)
            {
              const bool isQuad = mesh->GetCell(f)->GetNumberOfPoints() == 4;
              return isQuad ? 1.0 - cubes->GetTuple1(f) : 0.0;
            }) < 1e-6);
  }
}

/// Limits change no face; what fails them is counted, marked and said.
void TestLimits()
{
  vtkNew<vtkFieldAlignedRemesh> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(Meshes::ToPolyData(Meshes::Potato(3)));
  filter->SetNumberOfFaces(400);
  filter->Update();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(filter->GetOutput());
  CHECK(!before->GetCellData()->HasArray("Pass") && !before->GetFieldData()->HasArray("Pass"));
  vtkDataArray* const jacobian = before->GetCellData()->GetArray("ScaledJacobian");
  vtkDataArray* const ratio = before->GetCellData()->GetArray("AspectRatio");
  const double least = jacobian->GetRange()[0];
  CHECK(std::abs(Number(before, "LeastScaledJacobian") - least) < 1e-6);
  CHECK(std::abs(Number(before, "LargestAspectRatio") - ratio->GetRange()[1]) < 1e-6);
  CHECK(std::abs(Number(before, "LargestWarpage") -
          before->GetCellData()->GetArray("Warpage")->GetRange()[1]) < 1e-6);

  filter->SetMinimumScaledJacobian(0.5 * least);
  filter->SetMaximumWarpage(2.0);
  filter->Update();
  CHECK(messages->Warnings.empty());
  CHECK(Number(filter->GetOutput(), "Pass") == 1.0);
  CHECK(Number(filter->GetOutput(), "FailedFaces") == 0.0);
  CHECK(SummaryOf(filter->GetOutput()).find("all faces within the limits") != std::string::npos);

  filter->SetMinimumScaledJacobian(0.95);
  filter->SetMaximumAspectRatio(1.2);
  filter->Update();
  vtkPolyData* const mesh = filter->GetOutput();
  auto* const pass = vtkSignedCharArray::SafeDownCast(mesh->GetCellData()->GetArray("Pass"));
  CHECK(pass != nullptr && mesh->GetNumberOfCells() == before->GetNumberOfCells());
  int failed = 0;
  for (vtkIdType f = 0; pass && f < mesh->GetNumberOfCells(); ++f)
  {
    const bool isGood = jacobian->GetTuple1(f) >= 0.95 && ratio->GetTuple1(f) <= 1.2;
    CHECK(pass->GetValue(f) == (isGood ? 1 : 0));
    failed += isGood ? 0 : 1;
  }
  CHECK(failed > 0 && Number(mesh, "FailedFaces") == failed && Number(mesh, "Pass") == 0.0);
  CHECK(
    SummaryOf(mesh).find(std::to_string(failed) + " faces fail the limits") != std::string::npos);
  CHECK(messages->Warnings.size() == 1);

  // The figures are for those who want them, the faces that fail for all.
  filter->DiagnosticsOff();
  filter->Update();
  CHECK(mesh->GetFieldData()->GetNumberOfArrays() == 2 && mesh->GetCellData()->HasArray("Pass"));
}
}

int TestFieldAlignedRemeshQuality(int, char*[])
{
  TestIsThatOfMeshQuality();
  TestLimits();
  return Result();
}
