// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Singularities that points prescribe.

#include "Fields.h"
#include "PipelineChecks.h"

#include "vtkDirectionFieldSingularities.h"

#include "vtkMultiBlockDataSet.h"

#include <cmath>
#include <string>
#include <vector>

using namespace Checks;

namespace
{
struct Wanted
{
  double Place[3];
  int Index;
};

vtkSmartPointer<vtkPolyData> Points(const std::vector<Wanted>& wanted, bool withIndices = true)
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> index;
  index->SetName("SingularityIndex");
  for (const Wanted& singularity : wanted)
  {
    points->InsertNextPoint(singularity.Place);
    index->InsertNextValue(singularity.Index);
  }
  polyData->SetPoints(points);
  if (withIndices)
  {
    polyData->GetPointData()->AddArray(index);
  }
  return polyData;
}

/// The corners of a cube, where a cross field on the sphere turns least.
std::vector<Wanted> CubeCorners()
{
  std::vector<Wanted> corners;
  const double a = 1.0 / std::sqrt(3.0);
  for (int k = 0; k < 8; ++k)
  {
    corners.push_back({ { k & 1 ? a : -a, k & 2 ? a : -a, k & 4 ? a : -a }, 1 });
  }
  return corners;
}

vtkSmartPointer<vtkDirectionField> FieldOn(vtkPolyData* mesh, int degree = 4)
{
  auto field = vtkSmartPointer<vtkDirectionField>::New();
  field->SetInputData(mesh);
  field->SetDegree(degree);
  field->Update();
  return field;
}

vtkSmartPointer<vtkDirectionFieldSingularities> Edit(vtkAlgorithm* field, vtkDataObject* points)
{
  auto edit = vtkSmartPointer<vtkDirectionFieldSingularities>::New();
  edit->SetInputConnection(field->GetOutputPort());
  edit->SetSingularitiesData(points);
  return edit;
}

vtkPolyData* SingularitiesOf(vtkAlgorithm* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

vtkPolyData* OutputOf(vtkAlgorithm* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

void TestParameters()
{
  vtkNew<vtkDirectionFieldSingularities> filter;
  CHECK(filter->GetSingularityMode() == vtkDirectionFieldSingularities::REPLACE);
  CHECK(filter->GetObjective() == vtkDirectionFieldSingularities::SMOOTHEST);
  CHECK(!filter->GetBalanceAutomatically());
  CHECK(filter->GetKeepConstraints());
  CHECK(filter->GetAlignment() == vtkDirectionFieldSingularities::ALIGN_NONE);
  CHECK(filter->GetAlignmentStrength() == 0.5);
  CHECK(filter->GetKeepStages());
  CHECK(!filter->GetRefineWhereNeeded());
  filter->SetSingularityMode(7);
  filter->SetObjectiveToLeastChange();
  filter->BalanceAutomaticallyOn();
  filter->KeepConstraintsOff();
  filter->SetAlignment(9);
  filter->SetAlignmentStrength(2.0);
  filter->SetGuidanceVectors("Strokes");
  CHECK(PipelineChecks::Prints(filter,
    { "SingularityMode: 1\n", "Objective: 1\n", "BalanceAutomatically: 1\n", "KeepConstraints: 0\n",
      "Alignment: 2\n", "AlignmentStrength: 1\n", "GuidanceVectors: Strokes\n" }));
}

/// The singularities are where they are asked for, and the energy is less there than at eight other places.
void TestCubeCorners()
{
  auto field = FieldOn(PolyMeshes::Icosphere(4));
  auto edit = Edit(field, Points(CubeCorners()));
  edit->Update();
  vtkPolyData* singularities = SingularitiesOf(edit);
  REQUIRE(singularities->GetNumberOfPoints() == 8);
  CHECK(SumOfIndices(OutputOf(edit)->GetCellData()) == 8);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const double* p = singularities->GetPoint(i);
    for (int c = 0; c < 3; ++c)
    {
      CHECK(std::abs(std::abs(p[c]) - 1.0 / std::sqrt(3.0)) < 0.05);
    }
  }
  const double best = FieldValue(OutputOf(edit), "RotationEnergy");
  CHECK(FieldValue(OutputOf(edit), "WrongTriangles") == 0.0);
  CHECK(FieldValue(OutputOf(edit), "MaximumRotation") < 1.0);
  CheckDirections(OutputOf(edit), 4, 1e-5);
  std::vector<Wanted> moved = CubeCorners();
  moved[0].Place[0] = 0.2;
  edit->SetSingularitiesData(Points(moved));
  edit->Update();
  CHECK(FieldValue(OutputOf(edit), "RotationEnergy") > best + 1.0);
  // Without the array every point has the index 1.
  edit->SetSingularitiesData(Points(CubeCorners(), false));
  edit->Update();
  CHECK(FieldValue(OutputOf(edit), "RotationEnergy") == best);
}

/// The output of port 1 goes in again, and changes nothing where the least change is wanted.
void TestOwnSingularities()
{
  auto field = FieldOn(PolyMeshes::Icosphere(3), 2);
  auto edit = Edit(field, field->GetOutput(1));
  edit->SetObjectiveToLeastChange();
  edit->Update();
  CHECK(IsSame(Direction(field->GetOutput(), 0), Direction(OutputOf(edit), 0)));
  CHECK(IsSame(Direction(field->GetOutput(), 1), Direction(OutputOf(edit), 1)));
  CHECK(IsSame(field->GetOutput()->GetCellData()->GetArray("SingularityIndex"),
    OutputOf(edit)->GetCellData()->GetArray("SingularityIndex")));
}

/// Without a second input the field has its own singularities.
void TestWithoutPoints()
{
  for (const auto& mesh : { PolyMeshes::Icosphere(3), PolyMeshes::Pebble(4),
         PolyMeshes::QuadTorus(30, 14), PolyMeshes::Square(12) })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      auto field = FieldOn(mesh, degree);
      auto* const indices = field->GetOutput()->GetCellData()->GetArray("SingularityIndex");
      for (const int mode :
        { vtkDirectionFieldSingularities::REPLACE, vtkDirectionFieldSingularities::ADD })
      {
        for (const int objective : { vtkDirectionFieldSingularities::SMOOTHEST,
               vtkDirectionFieldSingularities::LEAST_CHANGE })
        {
          vtkNew<vtkDirectionFieldSingularities> edit;
          vtkNew<Messages> messages;
          messages->Observe(edit);
          edit->SetInputConnection(field->GetOutputPort());
          edit->SetSingularityMode(mode);
          edit->SetObjective(objective);
          edit->Update();
          CHECK(messages->IsEmpty());
          CHECK(IsSame(indices, OutputOf(edit)->GetCellData()->GetArray("SingularityIndex")));
          CHECK(
            SingularitiesOf(edit)->GetNumberOfPoints() == field->GetOutput(1)->GetNumberOfPoints());
          if (mode == vtkDirectionFieldSingularities::ADD)
          {
            CHECK(IsSame(Direction(field->GetOutput(), 0), Direction(OutputOf(edit), 0)));
            continue;
          }
          // It is the same as with the second output of the field.
          auto given = Edit(field, field->GetOutput(1));
          given->SetObjective(objective);
          given->Update();
          CHECK(IsSame(Direction(OutputOf(given), 0), Direction(OutputOf(edit), 0)));
        }
      }
    }
  }
}

void TestErrors()
{
  auto field = FieldOn(PolyMeshes::Icosphere(3));
  std::vector<Wanted> wanted = CubeCorners();
  wanted.pop_back();
  auto edit = Edit(field, Points(wanted));
  vtkNew<Messages> messages;
  messages->Observe(edit);
  edit->Update();
  CHECK(messages->IsOneError({ "add up to 7", "must add up to 8", "Balance Automatically" }));
  CHECK(OutputOf(edit)->GetNumberOfPoints() == 0);
  messages->Errors.clear();
  messages->Warnings.clear();
  edit->BalanceAutomaticallyOn();
  edit->Update();
  CHECK(messages->IsOneWarning({ "1 of index +1" }));
  CHECK(SumOfIndices(OutputOf(edit)->GetCellData()) == 8);
  messages->Errors.clear();
  messages->Warnings.clear();
  // A surface without a field.
  vtkNew<vtkDirectionFieldSingularities> bare;
  vtkNew<Messages> others;
  others->Observe(bare);
  bare->SetInputData(PolyMeshes::Icosphere(2));
  bare->SetSingularitiesData(Points(wanted));
  bare->Update();
  CHECK(others->IsOneError({ "Direction0", "Direction Field" }));
}

/// Eight singularities next to each other do not fit into a coarse mesh, but into one that is refined there.
void TestRefinement()
{
  auto field = FieldOn(PolyMeshes::Icosphere(2));
  std::vector<Wanted> wanted;
  for (int k = 0; k < 8; ++k)
  {
    wanted.push_back(
      { { 0.12 * std::cos(0.785 * k + 0.1), 0.12 * std::sin(0.785 * k + 0.1), 1.0 }, 1 });
  }
  auto edit = Edit(field, Points(wanted));
  vtkNew<Messages> messages;
  messages->Observe(edit);
  edit->Update();
  const double wrong = FieldValue(OutputOf(edit), "WrongTriangles");
  std::cout << "wrong before refinement: " << wrong << std::endl;
  CHECK(wrong > 0.0);
  CHECK(SumOfIndices(OutputOf(edit)->GetCellData()) == 8);
  edit->RefineWhereNeededOn();
  edit->Update();
  std::cout << "triangles: " << OutputOf(edit)->GetNumberOfCells()
            << ", wrong after refinement: " << FieldValue(OutputOf(edit), "WrongTriangles")
            << std::endl;
  CHECK(FieldValue(OutputOf(edit), "WrongTriangles") == 0.0);
  CHECK(OutputOf(edit)->GetNumberOfCells() > field->GetOutput()->GetNumberOfCells());
  CHECK(SingularitiesOf(edit)->GetNumberOfPoints() == 8);
  CheckDirections(OutputOf(edit), 4, 1e-5);
}

/// Each block has the singularities that are nearest to it.
void TestBlocks()
{
  auto near = FieldOn(PolyMeshes::Icosphere(3));
  vtkNew<vtkPolyData> far;
  far->DeepCopy(near->GetOutput());
  for (vtkIdType i = 0; i < far->GetNumberOfPoints(); ++i)
  {
    double p[3];
    far->GetPoint(i, p);
    p[0] += 5.0;
    far->GetPoints()->SetPoint(i, p);
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, near->GetOutput());
  blocks->SetBlock(1, far);
  vtkNew<vtkDirectionFieldSingularities> edit;
  edit->SetInputData(blocks);
  edit->SetSingularitiesData(Points(CubeCorners()));
  edit->Update();
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(edit->GetOutputDataObject(0));
  auto* const singular = vtkMultiBlockDataSet::SafeDownCast(edit->GetOutputDataObject(1));
  REQUIRE(output && singular);
  CHECK(vtkPolyData::SafeDownCast(singular->GetBlock(0))->GetNumberOfPoints() == 8);
  vtkNew<vtkDirectionFieldSingularities> own;
  own->SetInputData(blocks);
  own->SetObjectiveToLeastChange();
  own->Update();
  auto* const kept = vtkMultiBlockDataSet::SafeDownCast(own->GetOutputDataObject(0));
  REQUIRE(kept && kept->GetNumberOfBlocks() == 2);
  CHECK(IsSame(Direction(far, 0), Direction(vtkPolyData::SafeDownCast(kept->GetBlock(1)), 0)));
  // The other block keeps its field.
  CHECK(IsSame(Direction(far, 0), Direction(vtkPolyData::SafeDownCast(output->GetBlock(1)), 0)));
}
}

int TestDirectionFieldSingularities(int, char*[])
{
  TestParameters();
  TestCubeCorners();
  TestOwnSingularities();
  TestWithoutPoints();
  TestErrors();
  TestRefinement();
  TestBlocks();
  return Result();
}
