// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the filter behaves in a pipeline: parameters, progress, abort, attributes, repetition.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

#include <DirectionFields/OptionTable.h>
#include <DirectionFields/Options.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

using namespace Checks;

namespace
{
void TestDefaults()
{
  vtkNew<vtkDirectionField> filter;
  const DirectionFields::Options defaults;
#define EXPECT_DEFAULT(name, ...)                                                                  \
  CHECK(filter->Get##name() == static_cast<decltype(filter->Get##name())>(defaults.name));
  DIRECTIONFIELDS_OPTIONS(EXPECT_DEFAULT, EXPECT_DEFAULT, EXPECT_DEFAULT)
#undef EXPECT_DEFAULT
  CHECK(filter->GetKeepStages());
  CHECK(!filter->GetCellDirections());
  CHECK(filter->GetGuidanceVectors() == nullptr);
  CHECK(filter->GetGuidanceWeights() == nullptr);
  CHECK(filter->GetNumberOfInputPorts() == 1);
  CHECK(filter->GetNumberOfOutputPorts() == 2);
}

/// A value in the range other than the default, with few digits.
template <class Value>
Value Other(Value value, double least, double most)
{
  const double next = std::is_integral<Value>::value ? value + 1.0 : value + 0.125;
  const double other = next <= most ? next : 0.5 * (least + value);
  return static_cast<Value>(other);
}

void TestPrinting()
{
  vtkNew<vtkDirectionField> filter;
  std::vector<std::string> lines;
  const auto expect = [&lines](const char* name, const auto& value)
  {
    std::ostringstream line;
    line << " " << name << ": " << value << "\n";
    lines.push_back(line.str());
  };
#define CHANGE_FLAG(name, ...)                                                                     \
  filter->Set##name(!filter->Get##name());                                                         \
  expect(#name, filter->Get##name());
#define CHANGE_RANGE(name, ...)                                                                    \
  {                                                                                                \
    const auto before = filter->Get##name();                                                       \
    filter->Set##name(                                                                             \
      Other(before, filter->Get##name##MinValue(), filter->Get##name##MaxValue()));                \
    CHECK(filter->Get##name() != before);                                                          \
    expect(#name, filter->Get##name());                                                            \
  }
  DIRECTIONFIELDS_OPTIONS(CHANGE_FLAG, CHANGE_RANGE, CHANGE_RANGE)
#undef CHANGE_FLAG
#undef CHANGE_RANGE
  filter->KeepStagesOff();
  filter->CellDirectionsOn();
  filter->SetGuidanceVectors("wind");
  expect("KeepStages", 0);
  expect("CellDirections", 1);
  expect("GuidanceVectors", "wind");
  expect("GuidanceWeights", "(none)");
  std::ostringstream text;
  filter->Print(text);
  for (const std::string& line : lines)
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
  CHECK(lines.size() > 25);
}

void TestRanges()
{
  vtkNew<vtkDirectionField> filter;
  filter->SetDegree(0);
  CHECK(filter->GetDegree() == 1);
  filter->SetDegree(17);
  CHECK(filter->GetDegree() == 16);
  filter->SetEnergyBias(-1.5);
  CHECK(filter->GetEnergyBias() == -1.0);
  filter->SetEnergyBias(1.5);
  CHECK(filter->GetEnergyBias() == 1.0);
  filter->SetTolerance(0.0);
  CHECK(filter->GetTolerance() == 1e-12);
  filter->SetTolerance(1.0);
  CHECK(filter->GetTolerance() == 0.1);
  filter->SetMaximumIterations(0);
  CHECK(filter->GetMaximumIterations() == 1);
  filter->SetMaximumIterations(100000);
  CHECK(filter->GetMaximumIterations() == 10000);
  filter->SetSolver(3);
  CHECK(filter->GetSolver() == 2);
  filter->SetSolver(-1);
  CHECK(filter->GetSolver() == 0);
  filter->SetNumberOfThreads(-1);
  CHECK(filter->GetNumberOfThreads() == 0);
  filter->SetNumberOfThreads(100000);
  CHECK(filter->GetNumberOfThreads() == 1024);
  filter->SetAlignment(4);
  CHECK(filter->GetAlignment() == vtkDirectionField::ALIGN_TENSOR);
  filter->SetAlignment(-1);
  CHECK(filter->GetAlignment() == 0);
  filter->SetCurvatureDirection(4);
  CHECK(filter->GetCurvatureDirection() == vtkDirectionField::MOST_BENT);
  filter->SetCurvatureScale(33.0);
  CHECK(filter->GetCurvatureScale() == 32.0);
  filter->SetAlignmentStrength(1.5);
  CHECK(filter->GetAlignmentStrength() == 1.0);
  filter->SetAlignmentStrength(-0.5);
  CHECK(filter->GetAlignmentStrength() == 0.0);
  filter->SetShift(-1.0);
  CHECK(filter->GetShift() == 0.0);
  for (const double angle : { -1.0, 181.0 })
  {
    filter->SetFeatureAngle(angle);
    CHECK(filter->GetFeatureAngle() == (angle < 0.0 ? 0.0 : 180.0));
    filter->SetConsistencyAngle(angle);
    CHECK(filter->GetConsistencyAngle() == (angle < 0.0 ? 0.0 : 180.0));
  }
  filter->SetCurvatureTolerance(-1.0);
  CHECK(filter->GetCurvatureTolerance() == 0.0);
  filter->SetMinimumFeatureLength(-1.0);
  CHECK(filter->GetMinimumFeatureLength() == 0.0);
  filter->SetMergePoints(3);
  CHECK(filter->GetMergePoints() == 2);
  filter->MergePointsOff();
  CHECK(filter->GetMergePoints() == vtkDirectionField::MERGE_POINTS_OFF);
  filter->SetMergePoints(true);
  CHECK(filter->GetMergePoints() == vtkDirectionField::MERGE_POINTS_ON);
  filter->SetConstraintSolver(2);
  CHECK(filter->GetConstraintSolver() == 1);
}

void TestProgress()
{
  std::vector<double> steps;
  vtkNew<vtkCallbackCommand> record;
  record->SetClientData(&steps);
  record->SetCallback([](vtkObject*, unsigned long, void* client, void* progress)
    { static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(progress)); });
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(PolyMeshes::Pebble(3));
  filter->AddObserver(vtkCommand::ProgressEvent, record);
  filter->Update();
  CHECK(steps.size() >= 6);
  bool grows = true;
  for (size_t i = 1; i < steps.size(); ++i)
  {
    grows = grows && steps[i] >= steps[i - 1];
  }
  CHECK(grows);
  REQUIRE(!steps.empty());
  CHECK(steps.front() < 0.2);
  CHECK(steps.back() == 1.0);
  size_t between = 0;
  for (const double step : steps)
  {
    between += step > 0.1 && step < 0.9 ? 1 : 0;
  }
  CHECK(between >= 3);
}

/// An abort at whatever moment leaves empty outputs and is no error, and the next run is complete.
void TestAbort()
{
  for (const double when : { 0.0, 0.3, 0.6, 0.85 })
  {
    struct
    {
      double When;
      bool Fired;
    } state = { when, false };
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&state);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void* progress)
      {
        auto request = static_cast<decltype(state)*>(client);
        if (!request->Fired && *static_cast<double*>(progress) > request->When)
        {
          request->Fired = true;
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      });
    vtkNew<vtkDirectionField> filter;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(PolyMeshes::Pebble(3));
    filter->AddObserver(vtkCommand::ProgressEvent, stop);
    filter->Update();
    CHECK(state.Fired);
    CHECK(messages->IsEmpty());
    CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);

    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    CHECK(FieldValue(filter->GetOutput(), "IndexSum") == 8);
  }
}

/// Two runs give the same bytes.
void TestRepetition()
{
  vtkNew<vtkDirectionField> one, other;
  for (vtkDirectionField* filter : { one.Get(), other.Get() })
  {
    filter->SetInputData(
      PolyMeshes::BesideEachOther(PolyMeshes::Icosphere(3), PolyMeshes::QuadTorus(30, 15), 4.0));
    filter->SetDegree(6);
    filter->Update();
  }
  for (const int port : { 0, 1 })
  {
    CHECK(IsSame(one->GetOutput(port)->GetPointData(), other->GetOutput(port)->GetPointData()));
  }
  CHECK(IsSame(one->GetOutput()->GetCellData(), other->GetOutput()->GetCellData()));
  CHECK(IsSame(one->GetOutput()->GetFieldData(), other->GetOutput()->GetFieldData()));
  CHECK(
    IsSame(one->GetOutput(1)->GetPoints()->GetData(), other->GetOutput(1)->GetPoints()->GetData()));

  // The comparison tells another field from this one.
  other->SetEnergyBias(0.5);
  other->Update();
  CHECK(!IsSame(one->GetOutput()->GetPointData(), other->GetOutput()->GetPointData()));
}

/// Direction0 becomes the active vectors; the active scalars, the other arrays and the input itself stay.
void TestAttributes()
{
  auto mesh = PolyMeshes::Icosphere(1);
  const auto makeArray = [](const char* name, vtkIdType tuples, int components)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    array->Fill(1.0);
    return array;
  };
  mesh->GetPointData()->SetScalars(makeArray("temperature", mesh->GetNumberOfPoints(), 1));
  mesh->GetPointData()->SetVectors(makeArray("velocity", mesh->GetNumberOfPoints(), 3));
  mesh->GetCellData()->SetScalars(makeArray("pressure", mesh->GetNumberOfCells(), 1));
  mesh->GetFieldData()->AddArray(makeArray("time", 1, 1));
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->Update();
  vtkPolyData* field = filter->GetOutput();
  const auto nameOf = [](vtkDataArray* array)
  { return std::string(array && array->GetName() ? array->GetName() : ""); };
  CHECK(nameOf(field->GetPointData()->GetScalars()) == "temperature");
  CHECK(nameOf(field->GetPointData()->GetVectors()) == "Direction0");
  CHECK(nameOf(field->GetCellData()->GetScalars()) == "pressure");
  CHECK(field->GetPointData()->GetArray("velocity") != nullptr);
  CHECK(field->GetFieldData()->GetArray("time") != nullptr);
  CHECK(mesh->GetPointData()->GetNumberOfArrays() == 2);
  CHECK(nameOf(mesh->GetPointData()->GetVectors()) == "velocity");
  CHECK(mesh->GetCellData()->GetNumberOfArrays() == 1);
  CHECK(mesh->GetFieldData()->GetNumberOfArrays() == 1);

  // Without active scalars in the input there are none in the output.
  filter->SetInputData(PolyMeshes::Icosphere(1));
  filter->Update();
  CHECK(filter->GetOutput()->GetPointData()->GetScalars() == nullptr);
  CHECK(filter->GetOutput()->GetCellData()->GetScalars() == nullptr);
  CHECK(filter->GetOutput(1)->GetPointData()->GetNormals() != nullptr);
}

/// A field of lower degree, computed behind one of higher degree, leaves none of its arrays.
void TestChain()
{
  vtkNew<vtkDirectionField> first, second;
  first->SetInputData(PolyMeshes::Pebble(2));
  first->SetDegree(6);
  second->SetInputConnection(first->GetOutputPort());
  second->SetDegree(2);
  second->Update();
  CheckDirections(first->GetOutput(), 6, 1e-9);
  CheckDirections(second->GetOutput(), 2, 1e-9);
  for (int k = 2; k < 16; ++k)
  {
    CHECK(Direction(second->GetOutput(), k) == nullptr);
  }
  CHECK(FieldValue(first->GetOutput(), "IndexSum") == 12);
  CHECK(FieldValue(second->GetOutput(), "IndexSum") == 4);
  CHECK(second->GetOutput()->GetFieldData()->GetNumberOfArrays() == 11);

  // A filter whose degree was changed gives the same as a new one.
  first->SetDegree(2);
  first->Update();
  CHECK(IsSame(first->GetOutput()->GetPointData(), second->GetOutput()->GetPointData()));
}

/// The middle one of the angles from Direction0 of one field to the nearest direction of another.
double MiddleAngle(vtkPolyData* one, vtkPolyData* other, int degree)
{
  std::vector<double> angles;
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double d[3], e[3];
    Direction(one, 0)->GetTuple(i, d);
    angles.push_back(PolyMeshes::Pi);
    for (int k = 0; k < degree; ++k)
    {
      Direction(other, k)->GetTuple(i, e);
      angles.back() = std::min(angles.back(), vtkMath::AngleBetweenVectors(d, e));
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles[angles.size() / 2];
}

/// Steps of a series: the field of a turning surface turns with it, forwards and backwards; that of
/// each step by itself is another one at times.
void TestTimeSteps()
{
  vtkNew<vtkDirectionField> series;
  series->SetDegree(1);
  vtkNew<vtkPolyData> before;
  double largest = 0.0;
  double fromFresh = 0.0;
  for (int k = 0; k <= 50; ++k)
  {
    const int step = std::min(k, 75 - k);
    const double angle = 0.1 * step;
    auto mesh = PolyMeshes::Pebble(2);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      mesh->GetPoints()->SetPoint(i, std::cos(angle) * p[0] - std::sin(angle) * p[2], p[1],
        std::sin(angle) * p[0] + std::cos(angle) * p[2]);
    }
    vtkNew<vtkDirectionField> fresh;
    fresh->SetDegree(1);
    fresh->SetInputData(mesh);
    fresh->Update();
    mesh->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step);
    series->SetInputData(mesh);
    series->Update();
    CHECK(IsSame(series->GetOutput()->GetCellData(), fresh->GetOutput()->GetCellData()));
    fromFresh = std::max(fromFresh, MiddleAngle(fresh->GetOutput(), series->GetOutput(), 1));
    if (k > 0)
    {
      largest = std::max(largest, MiddleAngle(before, series->GetOutput(), 1));
    }
    before->DeepCopy(series->GetOutput());
  }
  CHECK(largest < 0.4);
  CHECK(fromFresh > 0.5);
}

/// A composite input is computed block by block.
void TestComposite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, PolyMeshes::Pebble(2));
  blocks->SetBlock(2, PolyMeshes::QuadTorus(20, 10));
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  CHECK(messages->IsEmpty());
  auto fields = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto singularities = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  REQUIRE(fields && singularities);
  REQUIRE(fields->GetNumberOfBlocks() == 3 && singularities->GetNumberOfBlocks() == 3);
  CHECK(fields->GetBlock(1) == nullptr);
  auto pebble = vtkPolyData::SafeDownCast(fields->GetBlock(0));
  auto torus = vtkPolyData::SafeDownCast(fields->GetBlock(2));
  REQUIRE(pebble && torus);
  CheckDirections(pebble, 4, 1e-9);
  CHECK(FieldValue(pebble, "IndexSum") == 8);
  CHECK(FieldValue(torus, "IndexSum") == 0);
  auto points = vtkPolyData::SafeDownCast(singularities->GetBlock(0));
  REQUIRE(points);
  CHECK(SumOfIndices(points->GetPointData()) == 8);
}
}

int TestDirectionFieldPipeline(int, char*[])
{
  TestDefaults();
  TestPrinting();
  TestRanges();
  TestProgress();
  TestAbort();
  TestRepetition();
  TestAttributes();
  TestChain();
  TestTimeSteps();
  TestComposite();
  return Result();
}
