// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guidance from curves, and fields that follow it.

#include "Fields.h"
#include "PipelineChecks.h"

#include "vtkGuidanceCurves.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <utility>

using namespace Checks;

namespace
{
/// A circle on the unit sphere, or near it, at a height.
vtkSmartPointer<vtkPolyData> Circle(double height, double radius = 1.0)
{
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const int parts = 200;
  lines->InsertNextCell(parts + 1);
  for (int i = 0; i <= parts; ++i)
  {
    const double angle = 2.0 * PolyMeshes::Pi * i / parts;
    const double ring = std::sqrt(1.0 - height * height);
    lines->InsertCellPoint(points->InsertNextPoint(
      radius * ring * std::cos(angle), radius * ring * std::sin(angle), radius * height));
  }
  curve->SetPoints(points);
  curve->SetLines(lines);
  return curve;
}

vtkSmartPointer<vtkGuidanceCurves> Make(vtkPolyData* mesh, vtkDataObject* curves, int degree = 4)
{
  auto filter = vtkSmartPointer<vtkGuidanceCurves>::New();
  filter->SetInputData(mesh);
  filter->SetCurvesData(curves);
  filter->SetDegree(degree);
  return filter;
}

vtkIdType CountGuided(vtkPolyData* output)
{
  vtkDataArray* weights = output->GetPointData()->GetArray("GuidanceWeights");
  vtkIdType count = 0;
  for (vtkIdType i = 0; weights && i < weights->GetNumberOfTuples(); ++i)
  {
    count += weights->GetComponent(i, 0) > 0.0 ? 1 : 0;
  }
  return count;
}

void TestParameters()
{
  vtkNew<vtkGuidanceCurves> filter;
  CHECK(filter->GetDegree() == 4);
  CHECK(filter->GetRadius() == 0.0);
  CHECK(filter->GetFalloff() == 0.5);
  CHECK(filter->GetMaximumDistance() == 0.0);
  CHECK(filter->GetNumberOfInputPorts() == 2);
  filter->SetDegree(99);
  filter->SetRadius(-1.0);
  filter->SetFalloff(0.0);
  filter->SetMaximumDistance(0.25);
  CHECK(PipelineChecks::Prints(
    filter, { "Degree: 16\n", "Radius: 0\n", "Falloff: 0.01\n", "MaximumDistance: 0.25\n" }));
}

/// A field with ConstrainGuidance goes along the circle.
void TestFieldFollows()
{
  auto mesh = PolyMeshes::Icosphere(4);
  auto curve = Circle(0.3);
  auto guidance = Make(mesh, curve);
  guidance->Update();
  vtkDataArray* vectors = guidance->GetOutput()->GetPointData()->GetArray("GuidanceVectors");
  REQUIRE(vectors && vectors->GetDataType() == VTK_DOUBLE);
  CHECK(CountGuided(guidance->GetOutput()) > 60);
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(guidance->GetOutputPort());
  field->SetGuidanceVectors("GuidanceVectors");
  field->SetGuidanceWeights("GuidanceWeights");
  field->ConstrainGuidanceOn();
  field->DropConstraintsAtSingularitiesOff();
  field->Update();
  double worst = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (guidance->GetOutput()->GetPointData()->GetArray("GuidanceWeights")->GetComponent(i, 0) >
      0.0)
    {
      const double* p = mesh->GetPoint(i);
      double along[3] = { -p[1], p[0], 0.0 };
      vtkMath::Normalize(along);
      double nearest = PolyMeshes::Pi;
      for (int k = 0; k < 4; ++k)
      {
        double d[3];
        Direction(field->GetOutput(), k)->GetTuple(i, d);
        nearest = std::min(nearest, vtkMath::AngleBetweenVectors(d, along));
      }
      worst = std::max(worst, nearest);
    }
  }
  std::cout << "largest angle to the circle: " << vtkMath::DegreesFromRadians(worst) << std::endl;
  CHECK(worst < vtkMath::RadiansFromDegrees(2.5));
}

/// The angle in degrees from a circle about the z axis to a cross field at each guided point: the
/// largest at those that a curve of strength 1 runs by, and at the others.
std::pair<double, double> AnglesToCircles(vtkPolyData* field)
{
  vtkDataArray* weights = field->GetPointData()->GetArray("GuidanceWeights");
  vtkDataArray* strengths = field->GetPointData()->GetArray("GuidanceStrengths");
  std::pair<double, double> worst(0.0, 0.0);
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    const double* p = field->GetPoint(i);
    double along[3] = { -p[1], p[0], 0.0 };
    vtkMath::Normalize(along);
    double nearest = PolyMeshes::Pi;
    for (int k = 0; k < 4; ++k)
    {
      double d[3];
      Direction(field, k)->GetTuple(i, d);
      nearest = std::min(nearest, vtkMath::AngleBetweenVectors(d, along));
    }
    if (weights->GetComponent(i, 0) > 0.0)
    {
      double& largest = strengths->GetComponent(i, 0) < 1.0 ? worst.second : worst.first;
      largest = std::max(largest, vtkMath::DegreesFromRadians(nearest));
    }
  }
  return worst;
}

/// Lines with a Strength below 1 are soft, the others are followed as without.
void TestStrengths()
{
  auto mesh = PolyMeshes::Icosphere(4);
  double last = 90.0;
  for (const double strength : { 0.01, 0.2, 0.9 })
  {
    vtkNew<vtkMultiBlockDataSet> curves;
    curves->SetBlock(0, Circle(0.1));
    auto soft = Circle(0.9);
    vtkNew<vtkDoubleArray> strengths;
    strengths->SetName("Strength");
    strengths->InsertNextValue(strength);
    soft->GetCellData()->AddArray(strengths);
    curves->SetBlock(1, soft);
    auto guidance = Make(mesh, curves);
    vtkNew<vtkDirectionField> field;
    field->SetInputConnection(guidance->GetOutputPort());
    field->SetGuidanceVectors("GuidanceVectors");
    field->SetGuidanceWeights("GuidanceWeights");
    field->SetGuidanceStrengths("GuidanceStrengths");
    field->ConstrainGuidanceOn();
    field->Update();
    const auto [hard, loose] = AnglesToCircles(field->GetOutput());
    std::cout << "strength " << strength << ": " << hard << ", " << loose << std::endl;
    CHECK(hard < 2.5);
    CHECK(loose < last);
    last = loose;
    // Without the array all are hard.
    field->SetGuidanceStrengths(nullptr);
    field->Update();
    CHECK(AnglesToCircles(field->GetOutput()).second < 7.0);
  }
  auto wrong = Circle(0.3);
  vtkNew<vtkDoubleArray> strengths;
  strengths->SetName("Strength");
  strengths->InsertNextValue(2.0);
  wrong->GetCellData()->AddArray(strengths);
  auto guidance = Make(mesh, wrong);
  vtkNew<Messages> messages;
  messages->Observe(guidance);
  guidance->Update();
  CHECK(messages->IsOneError({ "Strength", "0 to 1" }));
}

/// Whether a point array has the same values in both.
bool IsSame(vtkPolyData* a, vtkPolyData* b, const char* name)
{
  vtkDataArray* one = a->GetPointData()->GetArray(name);
  vtkDataArray* other = b->GetPointData()->GetArray(name);
  bool isSame = one && other && one->GetNumberOfValues() == other->GetNumberOfValues();
  for (vtkIdType i = 0; isSame && i < one->GetNumberOfValues(); ++i)
  {
    isSame = one->GetVariantValue(i) == other->GetVariantValue(i);
  }
  return isSame;
}

/// Curves of several blocks count together; polygons and float points are taken.
void TestInputs()
{
  auto mesh = PolyMeshes::Icosphere(3, VTK_FLOAT);
  vtkNew<vtkMultiBlockDataSet> curves;
  curves->SetBlock(0, Circle(0.5));
  curves->SetBlock(3, Circle(-0.5));
  auto both = Make(mesh, curves);
  auto one = Make(mesh, Circle(0.5));
  both->Update();
  one->Update();
  CHECK(CountGuided(one->GetOutput()) > 20);
  CHECK(CountGuided(both->GetOutput()) == 2 * CountGuided(one->GetOutput()));
  CHECK(both->GetOutput()->GetPointData()->GetArray("GuidanceVectors")->GetDataType() == VTK_FLOAT);

  auto torus = Make(PolyMeshes::QuadTorus(20, 10), Circle(0.0));
  torus->Update();
  CHECK(CountGuided(torus->GetOutput()) > 10);
  CHECK(torus->GetOutput()->GetNumberOfPolys() == 200);

  // The surface may be composite as well.
  vtkNew<vtkMultiBlockDataSet> surfaces;
  surfaces->SetBlock(0, mesh);
  surfaces->SetBlock(1, PolyMeshes::Icosphere(2));
  vtkNew<vtkGuidanceCurves> filter;
  filter->SetInputDataObject(0, surfaces);
  filter->SetCurvesData(curves);
  filter->Update();
  auto output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  REQUIRE(output && output->GetNumberOfBlocks() == 2);
  CHECK(
    CountGuided(vtkPolyData::SafeDownCast(output->GetBlock(0))) == CountGuided(both->GetOutput()));
}

/// The guidance of a surface beside others is that of the surface alone, and none for the others.
void TestBlocks()
{
  auto first = PolyMeshes::Icosphere(3);
  vtkNew<vtkPolyData> second;
  second->DeepCopy(first);
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    double place[3];
    second->GetPoint(i, place);
    second->GetPoints()->SetPoint(i, place[0] + 2.5, place[1], place[2]);
  }
  vtkNew<vtkPartitionedDataSetCollection> surfaces;
  surfaces->SetPartition(0, 0, first);
  surfaces->SetPartition(2, 1, second);
  auto curve = Circle(0.1);
  vtkNew<vtkDoubleArray> strength;
  strength->SetName("Strength");
  strength->InsertNextValue(0.5);
  curve->GetCellData()->AddArray(strength);
  auto alone = Make(first, curve);
  alone->Update();
  vtkNew<vtkGuidanceCurves> filter;
  filter->SetInputDataObject(0, surfaces);
  filter->SetCurvesData(curve);
  const auto check = [&](int with, int without)
  {
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->Update();
    CHECK(messages->IsEmpty());
    auto output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
    auto strokes = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(1));
    REQUIRE(output && strokes && output->GetNumberOfPartitionedDataSets() == 3);
    auto one = vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(with, with / 2));
    auto other = vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(without, without / 2));
    REQUIRE(one && other);
    for (const char* name : { "GuidanceVectors", "GuidanceWeights", "GuidanceStrengths" })
    {
      CHECK(IsSame(one, alone->GetOutput(), name));
      vtkDataArray* none = other->GetPointData()->GetArray(name);
      REQUIRE(none);
      double range[2];
      none->GetRange(range, -1);
      CHECK(range[0] == 0.0 && range[1] == 0.0);
    }
    auto drawn = vtkPolyData::SafeDownCast(strokes->GetPartitionAsDataObject(with, with / 2));
    auto empty = vtkPolyData::SafeDownCast(strokes->GetPartitionAsDataObject(without, without / 2));
    REQUIRE(drawn && empty);
    CHECK(drawn->GetNumberOfLines() == 1 + CountGuided(one));
    CHECK(empty->GetNumberOfLines() == 0);
    // The field of the other one is that without guidance, and no mistake.
    CHECK(other->GetFieldData()->HasArray("GuidedElsewhere"));
    CHECK(!one->GetFieldData()->HasArray("GuidedElsewhere"));
    vtkNew<vtkDirectionField> field;
    vtkNew<vtkDirectionField> free;
    messages->Observe(field);
    field->SetInputData(other);
    field->ConstrainGuidanceOn();
    field->SetGuidanceVectors("GuidanceVectors");
    field->SetGuidanceWeights("GuidanceWeights");
    field->SetGuidanceStrengths("GuidanceStrengths");
    free->SetInputData(second);
    field->Update();
    free->Update();
    CHECK(messages->IsEmpty());
    CHECK(!field->GetOutput()->GetFieldData()->HasArray("GuidedElsewhere"));
    CHECK(IsSame(field->GetOutput(), free->GetOutput(), "Direction0"));
  };
  check(0, 2);
  // What is kept of each block does not show where they change their places.
  surfaces->SetPartition(0, 0, second);
  surfaces->SetPartition(2, 1, first);
  surfaces->Modified();
  check(2, 0);

  // A block that is no surface is told, and left out.
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  surfaces->SetPartition(1, 0, image);
  surfaces->Modified();
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->IsOneWarning({ "vtkImageData", "Extract Surface" }));
}

/// What is kept of a surface does not show in the results, whatever changes.
void TestKept()
{
  auto mesh = PolyMeshes::Pebble(3);
  auto filter = Make(mesh, Circle(0.2));
  const auto check = [&](vtkPolyData* curve, int degree)
  {
    filter->SetCurvesData(curve);
    filter->SetDegree(degree);
    filter->Update();
    auto alone = Make(mesh, curve, degree);
    alone->Update();
    for (const char* name : { "GuidanceVectors", "GuidanceWeights" })
    {
      CHECK(IsSame(filter->GetOutput(), alone->GetOutput(), name));
    }
  };
  check(Circle(0.2), 4);
  check(Circle(-0.3), 4);
  check(Circle(-0.3), 2);
  // In place, which no modification time of an object of its own tells.
  double place[3];
  mesh->GetPoint(7, place);
  mesh->GetPoints()->SetPoint(7, 1.1 * place[0], 1.1 * place[1], 1.1 * place[2]);
  mesh->GetPoints()->Modified();
  mesh->Modified();
  check(Circle(-0.3), 2);
  mesh = PolyMeshes::Icosphere(2);
  filter->SetInputData(mesh);
  check(Circle(0.2), 4);
}

void TestMessages()
{
  auto mesh = PolyMeshes::Icosphere(2);
  const auto check = [&](vtkPolyData* curve, double most, std::initializer_list<const char*> words)
  {
    auto filter = Make(mesh, curve);
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetMaximumDistance(most);
    filter->Update();
    CHECK(messages->IsOneWarning(words));
    CHECK(CountGuided(filter->GetOutput()) == 0);
  };
  check(vtkNew<vtkPolyData>(), 0.0, { "no lines" });
  check(mesh, 0.0, { "no lines" });
  check(Circle(0.3, 2.0), 0.1, { "Maximum Distance" });

  auto broken = Circle(0.3);
  vtkNew<vtkCellArray> lines;
  const vtkIdType ids[3] = { 0, 9999, 1 };
  lines->InsertNextCell(3, ids);
  broken->SetLines(lines);
  auto filter = Make(mesh, broken);
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->Update();
  CHECK(messages->IsOneError({ "9999" }));

  auto empty = Make(vtkNew<vtkPolyData>(), Circle(0.3));
  vtkNew<Messages> none;
  none->Observe(empty);
  empty->Update();
  CHECK(none->IsEmpty());
  CHECK(empty->GetOutput()->GetNumberOfPoints() == 0);
}

void TestPipeline()
{
  auto mesh = PolyMeshes::Pebble(4);
  auto curve = Circle(0.2);
  PipelineChecks::CheckProgressAndAbort(
    [&]
    {
      auto filter = Make(mesh, curve, 2);
      filter->SetRadius(0.4);
      return filter;
    });
}
}

int TestDirectionFieldCurves(int, char*[])
{
  TestParameters();
  TestFieldFollows();
  TestStrengths();
  TestInputs();
  TestBlocks();
  TestKept();
  TestMessages();
  TestPipeline();
  return Result();
}
