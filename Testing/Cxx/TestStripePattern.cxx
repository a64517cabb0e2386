// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stripes in a pipeline: parameters, arrays of the outputs, data carried over, errors, unusual input, progress.

#include "Checks.h"
#include "Fields.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"
#include "PipelineChecks.h"

#include "vtkStripePattern.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkPoints.h"
#include "vtkTriangleFilter.h"

using namespace Checks;
using namespace PipelineChecks;

namespace
{
double AreaOf(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(triangles->GetOutputPort());
  return properties->GetSurfaceArea();
}

void TestParameters()
{
  vtkNew<vtkStripePattern> filter;
  CHECK(filter->GetStripeDirection() == vtkStripePattern::ALONG_FIELD);
  CHECK(filter->GetNumberOfOutputPorts() == 3);
  filter->SetStripeDirection(7);
  CHECK(filter->GetStripeDirection() == vtkStripePattern::ACROSS_FIELD);
  filter->SetSpacing(-1.0);
  CHECK(filter->GetSpacing() == 0.0);
  filter->SetSpacing(0.25);
  filter->SetSpacingArray("Size");
  filter->SetLineOffset(-2.0);
  filter->BandsOff();
  filter->TextureCoordinatesOn();
  CHECK(Prints(filter,
    { "StripeDirection: 1\n", "Spacing: 0.25\n", "SpacingArray: Size\n", "LineOffset: -1\n",
      "Bands: 0\n", "TextureCoordinates: 1\n" }));
}

void TestOutputs()
{
  auto mesh = PolyMeshes::Pebble(4);
  auto field = Field(mesh, 2);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  vtkNew<vtkIntArray> cell;
  cell->SetName("Cell");
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(field->GetPoint(i)[2]);
  }
  for (vtkIdType i = 0; i < field->GetNumberOfCells(); ++i)
  {
    cell->InsertNextValue(static_cast<int>(i));
  }
  field->GetPointData()->AddArray(height);
  field->GetCellData()->AddArray(cell);
  vtkNew<vtkStripePattern> filter;
  filter->SetInputData(field);
  filter->SetSpacing(0.15);
  filter->Update();
  vtkPolyData* lines = filter->GetOutput(0);
  vtkPolyData* bands = filter->GetOutput(1);
  vtkPolyData* branches = filter->GetOutput(2);
  CHECK(lines->GetNumberOfLines() > 10 && lines->GetNumberOfCells() == lines->GetNumberOfLines());
  CHECK(lines->GetPoints()->GetDataType() == VTK_DOUBLE);
  for (const char* name :
    { "LineId", "Length", "Closed", "ReasonForTermination", "StartNode", "EndNode" })
  {
    CHECK(lines->GetCellData()->GetArray(name) != nullptr);
  }
  CHECK(lines->GetPointData()->GetArray("ArcLength") && lines->GetPointData()->GetNormals());
  CHECK(bands->GetNumberOfPolys() == bands->GetNumberOfCells());
  CHECK(std::abs(AreaOf(bands) / AreaOf(mesh) - 1.0) < 1e-9);
  CHECK(bands->GetCellData()->GetScalars() == bands->GetCellData()->GetArray("Stripe"));
  CHECK(bands->GetPointData()->GetArray("Direction0") == nullptr);
  // Linear data stay linear within the cells, and cells have what their cell had.
  vtkDataArray* carried = bands->GetPointData()->GetArray("Height");
  REQUIRE(carried != nullptr);
  double worst = 0.0;
  for (vtkIdType i = 0; i < bands->GetNumberOfPoints(); ++i)
  {
    worst = std::max(worst, std::abs(carried->GetTuple1(i) - bands->GetPoint(i)[2]));
  }
  CHECK(worst < 1e-12);
  for (vtkIdType i = 0; i < bands->GetNumberOfCells(); ++i)
  {
    CHECK(bands->GetCellData()->GetArray("Cell")->GetTuple1(i) ==
      bands->GetCellData()->GetArray("CellId")->GetTuple1(i));
  }
  int ends = 0;
  int odd = 0;
  for (vtkIdType i = 0; i < branches->GetNumberOfPoints(); ++i)
  {
    ends += branches->GetPointData()->GetArray("StripeIndex")->GetTuple1(i) != 0.0 ? 1 : 0;
    odd += std::abs(branches->GetPointData()->GetArray("FieldIndex")->GetTuple1(i)) == 1.0 ? 1 : 0;
  }
  CHECK(ends == FieldValue(branches, "BranchPoints") && odd == 4);
  for (vtkPolyData* output : { lines, bands, branches })
  {
    CHECK(FieldValue(output, "Spacing") == 0.15);
    CHECK(FieldValue(output, "Misfit") > 0.0 && FieldValue(output, "Misfit") < 0.4);
    CHECK(FieldValue(output, "LineOffset") == 0.0);
  }

  filter->TextureCoordinatesOn();
  filter->Update();
  bands = filter->GetOutput(1);
  CHECK(bands->GetPointData()->GetTCoords() != nullptr);
  CHECK(std::abs(AreaOf(bands) / AreaOf(mesh) - 1.0) < 1e-9);
  filter->BandsOff();
  filter->Update();
  CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
  CHECK(filter->GetOutput(0)->GetNumberOfLines() > 10);
}

void TestSpacingArray()
{
  auto field = Field(PolyMeshes::Square(24), 1);
  vtkNew<vtkFloatArray> spacing;
  spacing->SetName("Size");
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    spacing->InsertNextValue(0.1f);
  }
  field->GetPointData()->AddArray(spacing);
  vtkNew<vtkStripePattern> filter;
  filter->SetInputData(field);
  filter->SetSpacing(0.1f);
  filter->Update();
  const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
  filter->SetSpacing(0.0);
  filter->SetSpacingArray("Size");
  filter->Update();
  CHECK(points > 100 && filter->GetOutput()->GetNumberOfPoints() == points);
}

void TestErrorsAndWarnings()
{
  vtkNew<vtkStripePattern> filter;
  const auto message = [&](bool isError, std::initializer_list<const char*> words)
  {
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->Modified();
    filter->Update();
    filter->RemoveObserver(messages);
    CHECK(isError ? messages->IsOneError(words) : messages->IsOneWarning(words));
    CHECK(!isError || filter->GetOutput(1)->GetNumberOfPoints() == 0);
  };
  filter->SetInputData(Field(PolyMeshes::Pebble(3), 4));
  message(false, { "degree 4", "Set Directions Per Point (Degree) of Direction Field to 2" });
  CHECK(filter->GetOutput(0)->GetNumberOfPoints() == 0);
  CHECK(filter->GetOutput(1)->GetPointData()->HasArray("Direction3"));
  CHECK(!filter->GetOutput(1)->GetCellData()->HasArray("Stripe"));
  filter->SetInputData(PolyMeshes::Pebble(2));
  message(true, { "Direction0", "Apply Direction Field first" });
  filter->SetInputData(Field(PolyMeshes::Pebble(3), 2));
  filter->SetSpacingArray("Nothing");
  message(true, { "Nothing", "Spacing Array" });
  filter->SetSpacingArray("None");
  filter->SetSpacing(1e-9);
  message(true, { "Raise Spacing" });
  filter->SetSpacing(0.1);
  filter->SetLineOffset(0.3);
  message(false, { "Line Offset", "multiple of 0.5" });
  CHECK(FieldValue(filter->GetOutput(), "LineOffset") == 0.5);
  filter->SetLineOffset(0.0);
  filter->SetInputData(Field(PolyMeshes::Icosphere(1), 2));
  filter->SetSpacing(0.02);
  message(false, { "too coarse", "Subdivide" });
}

void TestUnusualInput()
{
  vtkNew<Messages> messages;
  vtkNew<vtkStripePattern> filter;
  messages->Observe(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  for (auto mesh : { PolyMeshes::QuadTorus(30, 20), PolyMeshes::Moebius(40), PolyMeshes::QuadCube(),
         PolyMeshes::BesideEachOther(PolyMeshes::Icosphere(2), PolyMeshes::Square(6), 3.0) })
  {
    for (const int degree : { 1, 2 })
    {
      vtkNew<vtkDirectionField> field;
      vtkNew<Messages> ofTheField;
      ofTheField->Observe(field);
      field->SetInputData(mesh);
      field->SetDegree(degree);
      filter->SetInputConnection(field->GetOutputPort());
      filter->Update();
      CHECK(filter->GetOutput(0)->GetNumberOfLines() > 0);
      CHECK(std::abs(AreaOf(filter->GetOutput(1)) / AreaOf(mesh) - 1.0) < 1e-2);
      double bounds[6];
      filter->GetOutput(0)->GetBounds(bounds);
      CHECK(std::isfinite(bounds[0]) && std::abs(bounds[1]) < 10.0);
    }
  }
  // The two triangles of a cube's side are too coarse.
  CHECK(messages->Errors.empty());
  for (const std::string& warning : messages->Warnings)
  {
    CHECK(warning.find("too coarse") != std::string::npos);
  }
}
}

int TestStripePattern(int, char*[])
{
  TestParameters();
  TestOutputs();
  TestSpacingArray();
  TestErrorsAndWarnings();
  TestUnusualInput();
  auto field = Field(PolyMeshes::Pebble(4), 2);
  CheckProgressAndAbort(
    [&]
    {
      auto filter = vtkSmartPointer<vtkStripePattern>::New();
      filter->SetInputData(field);
      return filter;
    });
  return Result();
}
