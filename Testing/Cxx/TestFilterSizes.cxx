// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of any size and fields of any magnitude: each filter gives what it gives at size 1, in
// the surface's unit, although areas and squares have no numbers there. Where coordinates themselves
// have none beside them, an error says so.

#include "Checks.h"
#include "FilterOutputs.h"
#include "PolyMeshes.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkDirectionFieldWriter.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkGuidanceCurves.h"
#include "vtkStripePattern.h"

#include <limits>

using namespace Checks;
using namespace FilterOutputs;

namespace
{
/// 1e160, a power of two so that no digit is lost.
const double Large = std::ldexp(1.0, 531);

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

/// What lies beyond the numbers that can be computed with is an error of each filter that names the
/// point and says what to do, and leaves nothing.
void TestBeyondNumbers()
{
  const auto given = Field(Sized(1.0), 2);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto field = vtkSmartPointer<vtkPolyData>::New();
    field->DeepCopy(given);
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->InsertPoints(0, given->GetNumberOfPoints(), 0, given->GetPoints());
    const double most =
      type == VTK_FLOAT ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
    points->SetPoint(17, 0.0, -most, 0.0);
    points->SetPoint(40, 0.5 * most, 0.0, 0.0);
    field->SetPoints(points);
    vtkNew<vtkDirectionFieldWriter> writer;
    writer->SetFileName("beyond-numbers.rosy");
    for (const auto& filter : std::vector<vtkSmartPointer<vtkAlgorithm>>{
           vtkNew<vtkDirectionField>(), vtkNew<vtkDirectionFieldGlyphs>(),
           vtkNew<vtkDirectionFieldStreamlines>(), vtkNew<vtkStripePattern>(),
           vtkNew<vtkDirectionFieldSingularities>(), vtkNew<vtkCompareDirectionFields>(),
           vtkNew<vtkGuidanceCurves>(), vtkNew<vtkFieldAlignedRemesh>(), writer })
    {
      vtkNew<Messages> messages;
      messages->Observe(filter);
      for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
      {
        filter->SetInputDataObject(port, port == 0 ? field : given);
      }
      filter->Update();
      CHECK(messages->IsOneError({ "2 points of the surface have coordinates beyond",
        type == VTK_FLOAT ? "1e37" : "1e300", "the first is point 17. Scale the surface down" }));
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        auto* const output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
        CHECK(output == nullptr || output->GetNumberOfPoints() == 0);
      }
    }
  }
}

/// Lines farther apart than the surface is long are at their height above it, not anywhere.
void TestWideLines()
{
  for (const double spacing : { 1e10, 1e300, VTK_DOUBLE_MAX })
  {
    vtkNew<vtkDirectionFieldStreamlines> lines;
    lines->SetSeedType(vtkDirectionFieldStreamlines::SINGULARITIES);
    lines->SetSeparatingDistance(spacing);
    lines->SetOffset(1.0);
    lines->SetInputDataObject(0, Field(Sized(1.0), 4));
    lines->Update();
    CHECK(lines->GetOutput()->GetNumberOfPoints() > 0);
    CHECK(lines->GetOutput()->GetLength() < 50.0);
    CHECK(FieldValue(lines->GetOutput(), "SeparatingDistance") < 20.0);
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
    vtkNew<vtkDirectionFieldGlyphs> glyphs;
    glyphs->SetGlyphMode(vtkDirectionFieldGlyphs::ALL_POINTS);
    glyphs->SetInputDataObject(0, field);
    glyphs->Update();
    const double largest =
      glyphs->GetOutput()->GetCellData()->GetArray("RepresentationMagnitude")->GetRange()[1];
    CHECK(largest > 0.0 && std::isfinite(largest));
  }
}

/// Where a point is far away from the others, as in a broken file, each filter works, and what it
/// makes is finite. Lines along the spike may be too long for the memory, which is said.
void TestSpikes()
{
  for (const double spike : { 1e20, 1e100 })
  {
    const auto mesh = Sized(1.0);
    double place[3];
    mesh->GetPoint(17, place);
    vtkMath::MultiplyScalar(place, spike);
    mesh->GetPoints()->SetPoint(17, place);
    vtkNew<vtkDirectionField> crosses;
    vtkNew<vtkDirectionField> directed;
    vtkNew<Messages> mended;
    for (vtkDirectionField* field : { crosses.Get(), directed.Get() })
    {
      mended->Observe(field);
      field->SetDegree(field == crosses ? 4 : 2);
      field->SetInputData(mesh);
      field->Update();
    }
    CHECK(mended->Errors.empty());
    vtkPolyData* const cross = crosses->GetOutput();
    for (vtkIdType i = 0; i < cross->GetNumberOfPoints(); ++i)
    {
      CHECK(std::abs(vtkMath::Norm(Direction(cross, 0)->GetTuple3(i)) - 1.0) < 1e-9);
    }
    vtkNew<vtkDirectionField> aligned;
    aligned->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
    const auto lines = vtkSmartPointer<vtkDirectionFieldStreamlines>::New();
    lines->SetMaximumNumberOfLines(2);
    const auto stripes = vtkSmartPointer<vtkStripePattern>::New();
    for (const auto& filter :
      std::vector<vtkSmartPointer<vtkAlgorithm>>{ aligned, vtkNew<vtkDirectionFieldGlyphs>(), lines,
        stripes, vtkNew<vtkDirectionFieldSingularities>(), vtkNew<vtkCompareDirectionFields>(),
        vtkNew<vtkGuidanceCurves>(), vtkNew<vtkFieldAlignedRemesh>() })
    {
      vtkNew<Messages> messages;
      messages->Observe(filter);
      filter->SetInputDataObject(0, cross);
      if (filter->IsA("vtkCompareDirectionFields") || filter->IsA("vtkGuidanceCurves"))
      {
        filter->SetInputDataObject(1, cross);
      }
      if (filter == stripes)
      {
        filter->SetInputDataObject(0, directed->GetOutput());
      }
      filter->Update();
      if (filter == lines && !messages->Errors.empty())
      {
        CHECK(messages->IsOneError({ "Lower Maximum Streamline Length" }));
        continue;
      }
      CHECK(messages->Errors.empty());
      auto* const output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
      REQUIRE(output->GetNumberOfPoints() > 0);
      CHECK(std::isfinite(output->GetBounds()[0]) && std::isfinite(output->GetBounds()[1]));
    }
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
  TestBeyondNumbers();
  TestWideLines();
  TestMagnitudes();
  TestSpikes();
  TestEndlessLines();
  return Result();
}
