// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of any size and fields of any magnitude: each filter gives what it gives at size 1, in
// the surface's unit, although areas and squares have no numbers there.

#include "Checks.h"
#include "PolyMeshes.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkGuidanceCurves.h"
#include "vtkStripePattern.h"

using namespace Checks;

namespace
{
/// 1e160, a power of two so that no digit is lost.
const double Large = std::ldexp(1.0, 531);

vtkSmartPointer<vtkPolyData> Sized(double size)
{
  auto mesh = PolyMeshes::Pebble(2, VTK_DOUBLE);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    vtkMath::MultiplyScalar(point, size);
    mesh->GetPoints()->SetPoint(i, point);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> Field(vtkPolyData* mesh, int degree)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetDegree(degree);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

/// All outputs of all filters on a surface of a size.
std::vector<vtkSmartPointer<vtkPolyData>> OutputsAt(double size)
{
  const auto cross = Field(Sized(size), 4);
  const auto lines = Field(Sized(size), 2);
  vtkNew<vtkDirectionFieldStreamlines> curves;
  curves->SetSeedType(vtkDirectionFieldStreamlines::SINGULARITIES);
  curves->SetMaximumStreamlineLength(size);
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  vtkNew<Messages> messages;
  const auto add = [&](vtkPolyDataAlgorithm* filter, vtkPolyData* input, vtkPolyData* second)
  {
    messages->Observe(filter);
    filter->SetInputDataObject(0, input);
    if (second)
    {
      filter->SetInputDataObject(1, second);
    }
    filter->Update();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      outputs.emplace_back(filter->GetOutput(port));
    }
  };
  add(curves, cross, nullptr);
  vtkNew<vtkDirectionField> aligned;
  aligned->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  add(aligned, cross, nullptr);
  add(vtkNew<vtkDirectionFieldGlyphs>(), cross, nullptr);
  add(vtkNew<vtkDirectionFieldStreamlines>(), cross, nullptr);
  vtkNew<vtkStripePattern> stripes;
  stripes->SetSpacing(0.3 * size);
  add(stripes, lines, nullptr);
  add(vtkNew<vtkDirectionFieldSingularities>(), cross, nullptr);
  add(vtkNew<vtkCompareDirectionFields>(), cross, aligned->GetOutput());
  vtkNew<vtkGuidanceCurves> guidance;
  guidance->SetRadius(0.2 * size);
  add(guidance, cross, curves->GetOutput());
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetNumberOfFaces(200);
  add(remesh, cross, nullptr);
  CHECK(messages->IsEmpty());
  return outputs;
}

void TestSizes()
{
  const auto usual = OutputsAt(1.0);
  const std::vector<std::string> ofLength = { "SeparatingDistance", "EdgeLength", "MaximumDistance",
    "MeanMatchDistance", "MaximumMatchDistance" };
  const std::vector<std::string> same = { "MeanAngleDifference", "MaximumAngleDifference" };
  for (const double size : { Large, 1.0 / Large })
  {
    const auto outputs = OutputsAt(size);
    REQUIRE(outputs.size() == usual.size());
    for (std::size_t k = 0; k < outputs.size(); ++k)
    {
      vtkPolyData* const one = usual[k];
      vtkPolyData* const other = outputs[k];
      if (one->GetFieldData()->HasArray("Spacing"))
      {
        // Where stripes branch depends on rounding.
        CHECK(std::abs(FieldValue(other, "Spacing") / size - FieldValue(one, "Spacing")) < 1e-6);
        CHECK(3 * other->GetNumberOfCells() > 2 * one->GetNumberOfCells());
        CHECK(2 * other->GetNumberOfCells() < 3 * one->GetNumberOfCells());
        CHECK(vtkMath::AreBoundsInitialized(other->GetBounds()));
        continue;
      }
      CHECK(one->GetNumberOfCells() == other->GetNumberOfCells());
      REQUIRE(one->GetNumberOfPoints() == other->GetNumberOfPoints());
      double farthest = 0.0;
      for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          farthest =
            std::max(farthest, std::abs(one->GetPoint(i)[c] - other->GetPoint(i)[c] / size));
        }
      }
      CHECK(farthest < 1e-5);
      for (const std::string& name : ofLength)
      {
        const double value = FieldValue(one, name.c_str());
        CHECK(std::isnan(value) ||
          std::abs(FieldValue(other, name.c_str()) / size - value) <= 1e-6 * value);
      }
      for (const std::string& name : same)
      {
        const double value = FieldValue(one, name.c_str());
        CHECK(std::isnan(value) || std::abs(FieldValue(other, name.c_str()) - value) < 1e-6);
      }
    }
  }
}

/// One magnitude that has no square leaves the edited field finite, and the others their directions.
void TestMagnitudes()
{
  for (const double magnitude : { 1e300, 1e-300 })
  {
    const auto field = Field(Sized(1.0), 4);
    field->GetPointData()->GetArray("RepresentationMagnitude")->SetComponent(17, 0, magnitude);
    vtkNew<vtkDirectionFieldSingularities> edit;
    edit->SetObjective(vtkDirectionFieldSingularities::LEAST_CHANGE);
    vtkNew<Messages> messages;
    messages->Observe(edit);
    edit->SetInputDataObject(0, field);
    edit->Update();
    CHECK(messages->IsEmpty());
    CheckDirections(edit->GetOutput(), 4, 1e-9);
    CHECK(SumOfIndices(edit->GetOutput()->GetCellData()) == 8);
    CHECK(std::isfinite(FieldValue(edit->GetOutput(), "RotationEnergy")));
    CHECK(LargestAngle(edit->GetOutput(), field, 4) < 1e-3);
  }
}

/// Lines of any length end in an error before the memory does.
void TestEndlessLines()
{
  vtkNew<vtkDirectionFieldStreamlines> lines;
  vtkNew<Messages> messages;
  messages->Observe(lines);
  lines->SetSeedType(vtkDirectionFieldStreamlines::POINTS);
  lines->SetMaximumStreamlineLength(1e300);
  const auto field = Field(PolyMeshes::QuadTorus(12, 8), 4);
  lines->SetInputData(field);
  lines->SetInputDataObject(1, field);
  lines->Update();
  CHECK(messages->IsOneError({ "Lower Maximum Streamline Length" }));
  CHECK(lines->GetOutput()->GetNumberOfPoints() == 0);
}
}

int TestFilterSizes(int, char*[])
{
  TestSizes();
  TestMagnitudes();
  TestEndlessLines();
  return Result();
}
