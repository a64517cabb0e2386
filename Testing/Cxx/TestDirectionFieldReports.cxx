// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the filters say of their outputs: each its own, in one line, and no figures where none are asked for.

#include "Checks.h"
#include "Fields.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkGuidanceCurves.h"
#include "vtkStripePattern.h"

#include "vtkDoubleArray.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace Checks;

namespace
{
std::string SummaryOf(vtkDataObject* data)
{
  auto* const texts =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("Summary"));
  return texts && texts->GetNumberOfValues() == 1 ? std::string(texts->GetValue(0)) : "(none)";
}

/// The whole number in front of a word.
int NumberBefore(const std::string& text, const std::string& word)
{
  const auto end = text.find(' ' + word);
  if (end == std::string::npos)
  {
    return -1;
  }
  const auto begin = text.find_last_not_of("0123456789", end - 1);
  return std::atoi(text.c_str() + (begin == std::string::npos ? 0 : begin + 1));
}

vtkSmartPointer<vtkPolyData> Circle()
{
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(41);
  for (int i = 0; i <= 40; ++i)
  {
    const double angle = 2.0 * PolyMeshes::Pi * i / 40;
    lines->InsertCellPoint(points->InsertNextPoint(std::cos(angle), std::sin(angle), 0.0));
  }
  curve->SetPoints(points);
  curve->SetLines(lines);
  return curve;
}

/// All filters that take a field, on one.
/// @param crosses one of degree 4, for the mesh
std::vector<vtkSmartPointer<vtkDirectionFieldAlgorithm>> Consumers(
  vtkPolyData* field, vtkPolyData* crosses)
{
  std::vector<vtkSmartPointer<vtkDirectionFieldAlgorithm>> filters;
  filters.push_back(vtkSmartPointer<vtkDirectionField>::New());
  filters.push_back(vtkSmartPointer<vtkDirectionFieldGlyphs>::New());
  filters.push_back(vtkSmartPointer<vtkDirectionFieldStreamlines>::New());
  filters.push_back(vtkSmartPointer<vtkStripePattern>::New());
  filters.push_back(vtkSmartPointer<vtkFieldAlignedRemesh>::New());
  filters.push_back(vtkSmartPointer<vtkDirectionFieldSingularities>::New());
  filters.push_back(vtkSmartPointer<vtkCompareDirectionFields>::New());
  filters.push_back(vtkSmartPointer<vtkGuidanceCurves>::New());
  filters[6]->SetInputData(1, field);
  filters[7]->SetInputData(1, Circle());
  for (const auto& filter : filters)
  {
    filter->SetInputData(field);
  }
  filters[4]->SetInputData(crosses);
  return filters;
}

vtkPolyData* OutputOf(vtkAlgorithm* filter, int port)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
}

/// Every output has a line of its own, and no figures of the field before.
void TestEveryOutput()
{
  auto field = Field(PolyMeshes::Pebble(4), 2);
  const std::string before = SummaryOf(field);
  CHECK(before.find("singularities") != std::string::npos &&
    field->GetFieldData()->HasArray("Eigenvalue"));
  for (const auto& filter : Consumers(field, Field(PolyMeshes::Pebble(4), 4)))
  {
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->Update();
    CHECK(messages->IsEmpty());
    const bool isField = filter->IsA("vtkDirectionField");
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      const std::string summary = SummaryOf(OutputOf(filter, port));
      std::cout << filter->GetClassName() << ": " << summary << std::endl;
      CHECK(summary == SummaryOf(OutputOf(filter, 0)));
      CHECK(
        std::all_of(summary.begin(), summary.end(), [](char c) { return c >= ' ' && c <= '~'; }));
      CHECK(isField || summary != before);
      CHECK(isField || !OutputOf(filter, port)->GetFieldData()->HasArray("Eigenvalue"));
      // A smooth surface without a boundary has no lines that a mesh keeps.
      const bool isOfLines = filter->IsA("vtkFieldAlignedRemesh") && port == 2;
      CHECK(isOfLines == (OutputOf(filter, port)->GetNumberOfPoints() == 0));
    }
  }
}

/// The numbers in the lines are those of the outputs.
void TestNumbers()
{
  auto field = Field(PolyMeshes::Pebble(4), 2);
  const auto filters = Consumers(field, Field(PolyMeshes::Pebble(4), 4));
  for (const auto& filter : filters)
  {
    filter->Update();
  }
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[1], 0)), "glyphs") ==
    FieldValue(OutputOf(filters[1], 0), "NumberOfGlyphs"));
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[2], 0)), "lines") ==
    OutputOf(filters[2], 0)->GetNumberOfLines());
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[3], 0)), "branch points") ==
    FieldValue(OutputOf(filters[3], 1), "BranchPoints"));
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[4], 0)), "quads") ==
    FieldValue(OutputOf(filters[4], 0), "Quads"));
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[4], 1)), "irregular vertices") ==
    OutputOf(filters[4], 1)->GetNumberOfPoints());
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[5], 1)), "singularities") ==
    OutputOf(filters[5], 1)->GetNumberOfPoints());
  CHECK(SummaryOf(OutputOf(filters[6], 0))
          .find("between the fields 0 degrees on average, 0 at most; ") != std::string::npos);
  vtkDataArray* const weights =
    OutputOf(filters[7], 0)->GetPointData()->GetArray("GuidanceWeights");
  int guided = 0;
  for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
  {
    guided += weights->GetTuple1(i) > 0.0 ? 1 : 0;
  }
  CHECK(NumberBefore(SummaryOf(OutputOf(filters[7], 0)), "points of") == guided && guided > 10);
  // Of the strokes one is the curve.
  CHECK(OutputOf(filters[7], 1)->GetNumberOfLines() == guided + 1);
}

/// The shapes of faces, and the balls of irregular vertices.
void TestMesh()
{
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetInputData(PolyMeshes::Icosphere(4));
  remesh->SetNumberOfFaces(500);
  remesh->Update();
  vtkDataArray* const quality = remesh->GetOutput()->GetCellData()->GetArray("ScaledJacobian");
  REQUIRE(quality && quality->GetNumberOfTuples() == remesh->GetOutput()->GetNumberOfCells());
  double range[2];
  quality->GetRange(range);
  CHECK(range[0] > 0.2 && range[1] <= 1.0 && range[1] > 0.95);
  const std::string summary = SummaryOf(remesh->GetOutput());
  const auto at = summary.find("scaled Jacobian ");
  REQUIRE(at != std::string::npos);
  CHECK(std::abs(std::atof(summary.c_str() + at + 16) - range[0]) < 0.006);
  // Both ways.
  double there = 0.0, back = 0.0;
  REQUIRE(std::sscanf(summary.c_str() + at,
            "scaled Jacobian %*f or more, %lf or less from the surface, which is %lf or less",
            &there, &back) == 2);
  CHECK(std::abs(there - FieldValue(remesh->GetOutput(), "MaximumDistance")) < 0.006 * there);
  CHECK(std::abs(back - FieldValue(remesh->GetOutput(), "MaximumDistanceToMesh")) < 0.006 * back);
  vtkPolyData* const irregular = OutputOf(remesh, 1);
  vtkDataArray* const valence = irregular->GetPointData()->GetArray("Valence");
  vtkDataArray* const missing = irregular->GetPointData()->GetArray("MissingEdges");
  vtkDataArray* const size = irregular->GetPointData()->GetArray("Size");
  REQUIRE(valence && missing && size && valence->GetNumberOfTuples() > 0);
  double sum = 0.0;
  for (vtkIdType i = 0; i < valence->GetNumberOfTuples(); ++i)
  {
    CHECK(missing->GetTuple1(i) == 4.0 - valence->GetTuple1(i));
    CHECK(size->GetTuple1(i) > 0.0);
    sum += missing->GetTuple1(i);
  }
  // By Euler's formula, where all faces are quads.
  CHECK(FieldValue(remesh->GetOutput(), "Triangles") > 0.0 || sum == 8.0);
}

/// Without Diagnostics only the lines are left, and what somebody else has put there.
void TestWithoutDiagnostics()
{
  auto mesh = PolyMeshes::Pebble(4);
  vtkNew<vtkDoubleArray> own;
  own->SetName("Triangles");
  own->InsertNextValue(7.0);
  mesh->GetFieldData()->AddArray(own);
  vtkNew<vtkDirectionField> field;
  field->SetInputData(mesh);
  field->SetDegree(2);
  field->DiagnosticsOff();
  field->Update();
  for (const int port : { 0, 1 })
  {
    CHECK(field->GetOutput(port)->GetFieldData()->GetNumberOfArrays() == 2);
    CHECK(field->GetOutput(port)->GetFieldData()->GetAbstractArray("Triangles") == own);
  }
  auto input = vtkSmartPointer<vtkPolyData>::New();
  input->ShallowCopy(field->GetOutput());
  input->GetFieldData()->RemoveArray("Triangles");
  for (const auto& filter : Consumers(input, Field(PolyMeshes::Pebble(4), 4)))
  {
    filter->DiagnosticsOff();
    filter->Update();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      CHECK(OutputOf(filter, port)->GetFieldData()->GetNumberOfArrays() == 1);
      CHECK(SummaryOf(OutputOf(filter, port)) != "(none)");
    }
    if (filter->IsA("vtkDirectionFieldStreamlines"))
    {
      CHECK(OutputOf(filter, 0)->GetPointData()->GetNumberOfArrays() == 3);
      CHECK(OutputOf(filter, 0)->GetCellData()->GetNumberOfArrays() == 1);
    }
  }
}

/// A field on a surface with guidance says where it does not use it.
void TestUnusedGuidance()
{
  vtkNew<vtkGuidanceCurves> guidance;
  guidance->SetInputData(PolyMeshes::Icosphere(3));
  guidance->SetCurvesData(Circle());
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(guidance->GetOutputPort());
  field->Update();
  CHECK(SummaryOf(field->GetOutput()).find("guidance is there but not used") != std::string::npos);
  field->ConstrainGuidanceOn();
  field->SetGuidanceVectors("GuidanceVectors");
  field->SetGuidanceWeights("GuidanceWeights");
  field->Update();
  CHECK(SummaryOf(field->GetOutput()).find("not used") == std::string::npos);
  CHECK(SummaryOf(field->GetOutput()).find("points constrained") != std::string::npos);
}

/// Without a second input two filters ask for it in one sentence, and give the first one back.
void TestWithoutSecondInput()
{
  auto field = Field(PolyMeshes::Icosphere(2), 4);
  vtkNew<vtkGuidanceCurves> guidance;
  vtkNew<vtkCompareDirectionFields> comparison;
  for (vtkDirectionFieldAlgorithm* const filter :
    { static_cast<vtkDirectionFieldAlgorithm*>(guidance),
      static_cast<vtkDirectionFieldAlgorithm*>(comparison) })
  {
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(field);
    filter->Update();
    CHECK(messages->IsOneWarning({ "Choose the", "Change Input" }));
    CHECK(OutputOf(filter, 0)->GetNumberOfPoints() == field->GetNumberOfPoints());
    CHECK(OutputOf(filter, 0)->GetNumberOfCells() == field->GetNumberOfCells());
    CHECK(!OutputOf(filter, 0)->GetPointData()->HasArray("GuidanceVectors"));
    CHECK(!OutputOf(filter, 0)->GetPointData()->HasArray("AngleDifference"));
  }
}
}

int TestDirectionFieldReports(int, char*[])
{
  TestEveryOutput();
  TestNumbers();
  TestMesh();
  TestWithoutDiagnostics();
  TestUnusedGuidance();
  TestWithoutSecondInput();
  return Result();
}
