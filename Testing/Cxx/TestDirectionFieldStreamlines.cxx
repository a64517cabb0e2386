// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Checks.h"
#include "Fields.h"
#include "PolyMeshes.h"

#include "vtkDirectionFieldStreamlines.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace Checks;

namespace
{
void TestArrays()
{
  const auto field = Field(PolyMeshes::Icosphere(3), 4);
  vtkNew<vtkDirectionFieldStreamlines> filter;
  filter->SetInputData(field);
  filter->Update();
  vtkPolyData* lines = filter->GetOutput(0);
  CHECK(lines->GetNumberOfLines() > 5 && lines->GetNumberOfLines() == lines->GetNumberOfCells());
  vtkPointData* points = lines->GetPointData();
  for (const char* name :
    { "Normals", "Direction", "ArcLength", "RepresentationMagnitude", "PointId", "Branch" })
  {
    CHECK(points->GetArray(name) &&
      points->GetArray(name)->GetNumberOfTuples() == lines->GetNumberOfPoints());
  }
  for (const char* name :
    { "SeedIds", "Family", "Length", "Closed", "ReasonForTermination", "StartNode", "EndNode" })
  {
    CHECK(lines->GetCellData()->GetArray(name) &&
      lines->GetCellData()->GetArray(name)->GetNumberOfTuples() == lines->GetNumberOfCells());
  }
  // No array that viewers color by unasked.
  CHECK(!points->GetScalars() && !lines->GetCellData()->GetScalars());
  CHECK(points->GetNormals() && points->GetVectors());
  const double spacing = FieldValue(lines, "SeparatingDistance");
  CHECK(std::abs(spacing - std::sqrt(4.0 * vtkMath::Pi()) / 40.0) < 0.01 * spacing);
  // Directions are those of the field at the nearest point, nearly.
  double least = 1.0;
  for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
  {
    double along[3], given[3], normal[3], position[3];
    points->GetVectors()->GetTuple(p, along);
    points->GetNormals()->GetTuple(p, normal);
    lines->GetPoint(p, position);
    const auto at = static_cast<vtkIdType>(points->GetArray("PointId")->GetTuple1(p));
    const int k = static_cast<int>(points->GetArray("Branch")->GetTuple1(p));
    Direction(field, k)->GetTuple(at, given);
    least = std::min(least, vtkMath::Dot(along, given));
    CHECK(std::abs(vtkMath::Norm(along) - 1.0) < 1e-5);
    // Above the sphere, of which the triangles are below.
    CHECK(vtkMath::Dot(normal, position) > 0.95);
  }
  CHECK(least > 0.7);
}

void TestNodes()
{
  const auto field = Field(PolyMeshes::Icosphere(3), 4);
  vtkNew<vtkDirectionFieldStreamlines> filter;
  filter->SetInputData(field);
  filter->SetSeedType(vtkDirectionFieldStreamlines::SINGULARITIES);
  filter->StopAtCrossingsOn();
  filter->Update();
  vtkPolyData* lines = filter->GetOutput(0);
  vtkPolyData* nodes = filter->GetOutput(1);
  CHECK(nodes->GetNumberOfVerts() == nodes->GetNumberOfPoints());
  int sum = 0;
  int singularities = 0;
  vtkPointData* data = nodes->GetPointData();
  for (vtkIdType p = 0; p < nodes->GetNumberOfPoints(); ++p)
  {
    const auto index = static_cast<int>(data->GetArray("SingularityIndex")->GetTuple1(p));
    sum += index;
    CHECK(std::abs(data->GetArray("Index")->GetTuple1(p) - 0.25 * index) < 1e-6);
    const bool isSingular = data->GetArray("NodeType")->GetTuple1(p) == 0.0;
    CHECK(isSingular == (index != 0));
    singularities += isSingular;
    const auto cell = static_cast<vtkIdType>(data->GetArray("CellId")->GetTuple1(p));
    CHECK(cell >= 0 && cell < field->GetNumberOfCells());
    if (isSingular)
    {
      CHECK(field->GetCellData()->GetArray("SingularityIndex")->GetTuple1(cell) == index);
    }
  }
  CHECK(sum == 8);
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    const auto start =
      static_cast<vtkIdType>(lines->GetCellData()->GetArray("StartNode")->GetTuple1(i));
    const auto end =
      static_cast<vtkIdType>(lines->GetCellData()->GetArray("EndNode")->GetTuple1(i));
    CHECK(start >= 0 && start < singularities && end >= 0 && end < nodes->GetNumberOfPoints());
    vtkNew<vtkIdList> ids;
    lines->GetCellPoints(i, ids);
    double a[3], b[3];
    lines->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1), a);
    nodes->GetPoint(end, b);
    CHECK(vtkMath::Distance2BetweenPoints(a, b) < 1e-3);
  }
}

void TestSeeds()
{
  const auto field = Field(PolyMeshes::Icosphere(3), 4);
  vtkNew<vtkPolyData> seeds;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(2.0, 0.1, 0.2);
  points->InsertNextPoint(std::nan(""), 0.0, 0.0);
  points->InsertNextPoint(0.0, -0.3, 0.9);
  seeds->SetPoints(points);
  vtkNew<vtkDirectionFieldStreamlines> filter;
  filter->SetInputData(0, field);
  filter->SetSeedType(vtkDirectionFieldStreamlines::POINTS);
  vtkNew<Messages> observed;
  Messages& missing = *observed;
  missing.Observe(filter);
  filter->Update();
  CHECK(missing.IsOneError({ "Seed Source", "Seed Type" }));
  CHECK(filter->GetOutput(0)->GetNumberOfCells() == 0);
  filter->SetInputData(1, seeds);
  filter->SetMaximumStreamlineLength(1.0);
  missing.Errors.clear();
  filter->Update();
  CHECK(missing.IsEmpty());
  vtkPolyData* lines = filter->GetOutput(0);
  // Two families at each of two points.
  CHECK(lines->GetNumberOfCells() == 4);
  CHECK(lines->GetCellData()->GetArray("SeedIds")->GetTuple1(3) == 2.0);
  CHECK(lines->GetCellData()->GetArray("Length")->GetRange()[1] < 1.001);
  filter->SetMaximumNumberOfLines(3);
  filter->Update();
  CHECK(missing.IsOneWarning({ "Maximum Number Of Lines", "Spacing" }));
  CHECK(filter->GetOutput(0)->GetNumberOfCells() == 3);
}

void TestInputs()
{
  vtkNew<vtkDirectionFieldStreamlines> filter;
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  vtkNew<Messages> observed;
  Messages& messages = *observed;
  messages.Observe(filter);
  filter->Update();
  CHECK(messages.IsEmpty());
  CHECK(filter->GetOutput(0)->GetNumberOfCells() == 0);
  filter->SetInputData(PolyMeshes::Icosphere(1));
  filter->Update();
  CHECK(messages.IsOneError({ "Direction0" }));
  CHECK(filter->GetOutput(0)->GetNumberOfPoints() == 0);
  // Ghosts have no seeds: lines start on the other half.
  const auto field = Field(PolyMeshes::Icosphere(3), 2);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfTuples(field->GetNumberOfCells());
  ghosts->FillValue(vtkDataSetAttributes::DUPLICATECELL);
  field->GetCellData()->AddArray(ghosts);
  filter->SetInputData(field);
  messages.Errors.clear();
  filter->Update();
  CHECK(messages.IsEmpty());
  CHECK(filter->GetOutput(0)->GetNumberOfCells() == 0);
}

void TestAbort()
{
  const auto field = Field(PolyMeshes::Icosphere(5), 4);
  vtkNew<vtkDirectionFieldStreamlines> filter;
  filter->SetInputData(field);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  CHECK(filter->GetOutput(0)->GetNumberOfCells() == 0);
  CHECK(filter->GetOutput(1)->GetNumberOfCells() == 0);
}
}

int TestDirectionFieldStreamlines(int, char*[])
{
  TestArrays();
  TestNodes();
  TestSeeds();
  TestInputs();
  TestAbort();
  return Result();
}
