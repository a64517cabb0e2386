// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The comparison of two fields.

#include "Fields.h"
#include "PipelineChecks.h"

#include "vtkCompareDirectionFields.h"

#include "vtkMultiBlockDataSet.h"

using namespace Checks;

namespace
{
vtkSmartPointer<vtkCompareDirectionFields> Make(vtkDataObject* one, vtkDataObject* other)
{
  auto filter = vtkSmartPointer<vtkCompareDirectionFields>::New();
  filter->SetInputDataObject(0, one);
  filter->SetOtherData(other);
  return filter;
}

vtkSmartPointer<vtkPolyData> BiasedField(vtkPolyData* mesh, int degree, double bias)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetDegree(degree);
  filter->SetEnergyBias(bias);
  filter->Update();
  return filter->GetOutput();
}

/// How many singularities match, and how many are in the first or the second field only.
double Matched(vtkPolyData* output, int component)
{
  vtkDataArray* array = output->GetFieldData()->GetArray("MatchedSingularities");
  return array ? array->GetComponent(0, component) : -1.0;
}

void TestParameters()
{
  vtkNew<vtkCompareDirectionFields> filter;
  CHECK(filter->GetMatchSingularities());
  CHECK(!filter->GetDivergenceAndCurl());
  CHECK(filter->GetNumberOfInputPorts() == 2);
  CHECK(filter->GetNumberOfOutputPorts() == 2);
  filter->MatchSingularitiesOff();
  filter->DivergenceAndCurlOn();
  CHECK(PipelineChecks::Prints(filter, { "MatchSingularities: 0\n", "DivergenceAndCurl: 1\n" }));
}

void TestDifference()
{
  auto mesh = PolyMeshes::Pebble(3);
  for (const int degree : { 1, 2, 4, 6 })
  {
    auto one = Field(mesh, degree);
    auto same = Make(one, one);
    same->Update();
    CHECK(FieldValue(same->GetOutput(), "MaximumAngleDifference") < 1e-6);
    CHECK(Matched(same->GetOutput(), 1) == 0);
    CHECK(Matched(same->GetOutput(), 2) == 0);
    CHECK(FieldValue(same->GetOutput(), "MaximumMatchDistance") < 1e-9);
    auto other = BiasedField(mesh, degree, 0.9);
    auto filter = Make(one, other);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    vtkDataArray* angles = output->GetPointData()->GetScalars();
    REQUIRE(angles && std::string(angles->GetName()) == "AngleDifference");
    const double most = FieldValue(output, "MaximumAngleDifference");
    CHECK(std::abs(angles->GetRange()[1] - most) < 1e-12);
    CHECK(most <= 180.0 / degree + 1e-9);
    CHECK(std::abs(most - vtkMath::DegreesFromRadians(LargestAngle(one, other, degree))) < 1e-4);
    const double mean = FieldValue(output, "MeanAngleDifference");
    CHECK(mean > 0.0 && mean < most);
    // The other way around it is the same.
    auto back = Make(other, one);
    back->Update();
    CHECK(std::abs(FieldValue(back->GetOutput(), "MeanAngleDifference") - mean) < 1e-9);
    for (int c = 0; c < 3; ++c)
    {
      CHECK(Matched(back->GetOutput(), c) == Matched(output, c == 0 ? 0 : 3 - c));
    }
    vtkPolyData* matches = filter->GetOutput(1);
    CHECK(matches->GetNumberOfLines() == Matched(output, 0));
    CHECK(matches->GetNumberOfVerts() == matches->GetNumberOfPoints());
    CHECK(matches->GetNumberOfPoints() ==
      2 * Matched(output, 0) + Matched(output, 1) + Matched(output, 2));
    for (const char* name : { "Field", "SingularityIndex", "Match", "MatchDistance", "CellId" })
    {
      CHECK(matches->GetPointData()->GetArray(name) != nullptr);
    }
    filter->MatchSingularitiesOff();
    filter->Update();
    CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
  }
}

void TestDerivatives()
{
  auto mesh = PolyMeshes::QuadTorus(40, 20);
  auto filter = Make(Field(mesh, 1), Field(mesh, 1));
  filter->DivergenceAndCurlOn();
  filter->Update();
  for (const char* name : { "Divergence0", "Curl0", "Divergence1", "Curl1" })
  {
    vtkDataArray* array = filter->GetOutput()->GetCellData()->GetArray(name);
    REQUIRE(array && array->GetNumberOfTuples() == mesh->GetNumberOfCells());
    CHECK(array->GetRange()[1] < 10.0);
    CHECK(array->GetRange()[1] > -10.0);
  }
  auto cross = Make(Field(mesh, 4), Field(mesh, 4));
  vtkNew<Messages> messages;
  messages->Observe(cross);
  cross->DivergenceAndCurlOn();
  cross->Update();
  CHECK(messages->IsOneError({ "degree 4" }));
}

void TestErrors()
{
  const auto check =
    [](vtkPolyData* one, vtkPolyData* other, std::initializer_list<const char*> words)
  {
    auto filter = Make(one, other);
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->Update();
    CHECK(messages->IsOneError(words));
    CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);
  };
  auto mesh = PolyMeshes::Pebble(1);
  auto field = Field(mesh, 4);
  check(mesh, field, { "Direction0" });
  check(field, mesh, { "Direction0" });
  check(field, Field(mesh, 2), { "degrees, 4 and 2" });
  check(field, Field(PolyMeshes::Pebble(2), 4), { "42 and 162 points" });
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(field);
  moved->GetPoints()->SetPoint(3, 5.0, 0.0, 0.0);
  check(field, moved, { "apart" });

  vtkNew<vtkPolyData> empty;
  auto nothing = Make(empty, empty);
  vtkNew<Messages> messages;
  messages->Observe(nothing);
  nothing->Update();
  CHECK(messages->IsEmpty());
}

/// Blocks are compared with blocks, or all with one surface.
void TestComposite()
{
  auto mesh = PolyMeshes::Pebble(2);
  auto torus = PolyMeshes::QuadTorus(20, 10);
  vtkNew<vtkMultiBlockDataSet> one, other;
  one->SetBlock(0, Field(mesh, 4));
  one->SetBlock(2, Field(torus, 4));
  other->SetBlock(0, BiasedField(mesh, 4, 0.9));
  other->SetBlock(2, Field(torus, 4));
  auto filter = Make(one, other);
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->IsEmpty());
  auto output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  REQUIRE(output && output->GetNumberOfBlocks() == 3);
  auto first = vtkPolyData::SafeDownCast(output->GetBlock(0));
  auto second = vtkPolyData::SafeDownCast(output->GetBlock(2));
  REQUIRE(first && second);
  CHECK(FieldValue(first, "MeanAngleDifference") > 0.1);
  CHECK(FieldValue(second, "MeanAngleDifference") < 1e-6);
}

void TestPipeline()
{
  auto mesh = PolyMeshes::Pebble(4);
  auto one = Field(mesh, 4);
  auto other = BiasedField(mesh, 4, 0.9);
  PipelineChecks::CheckProgressAndAbort([&] { return Make(one, other); });
}

/// The order of the inputs does not matter where points across seams are one for one field only.
void TestSeams()
{
  auto mesh = PolyMeshes::Pebble(2);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> corners;
    mesh->GetCellPoints(i, corners);
    cells->InsertNextCell(3);
    for (vtkIdType c = 0; c < 3; ++c)
    {
      cells->InsertCellPoint(points->InsertNextPoint(mesh->GetPoint(corners->GetId(c))));
    }
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(points);
  soup->SetPolys(cells);
  std::vector<vtkSmartPointer<vtkPolyData>> fields;
  // Facets that stay apart are a warning, which this does not test.
  vtkObject::GlobalWarningDisplayOff();
  for (const int merges :
    { vtkDirectionField::MERGE_POINTS_OFF, vtkDirectionField::MERGE_POINTS_AUTOMATIC })
  {
    vtkNew<vtkDirectionField> filter;
    filter->SetInputData(soup);
    filter->SetDegree(4);
    filter->SetMergePoints(merges);
    filter->Update();
    fields.push_back(filter->GetOutput());
  }
  vtkObject::GlobalWarningDisplayOn();
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  for (const std::size_t first : { 0, 1 })
  {
    vtkNew<vtkCompareDirectionFields> compare;
    compare->SetInputData(fields[first]);
    compare->SetOtherData(fields[1 - first]);
    compare->Update();
    outputs.push_back(compare->GetOutput());
  }
  double worst = 0.0;
  double largest = 0.0;
  vtkDataArray* one = outputs[0]->GetPointData()->GetArray("AngleDifference");
  vtkDataArray* other = outputs[1]->GetPointData()->GetArray("AngleDifference");
  REQUIRE(one && other);
  for (vtkIdType i = 0; i < soup->GetNumberOfPoints(); ++i)
  {
    worst = std::max(worst, std::abs(one->GetComponent(i, 0) - other->GetComponent(i, 0)));
    largest = std::max(largest, one->GetComponent(i, 0));
  }
  std::cout << "seams: angles differ by " << worst << " of " << largest << std::endl;
  CHECK(largest > 1.0);
  CHECK(worst < 1e-4);
}
}

int TestDirectionFieldComparison(int, char*[])
{
  TestParameters();
  TestDifference();
  TestDerivatives();
  TestErrors();
  TestComposite();
  TestPipeline();
  TestSeams();
  return Result();
}
