// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The data that a filter keeps from run to run change nothing; see also TestDirectionFieldSaving.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkDoubleArray.h"
#include "vtkUnsignedCharArray.h"

#include <DirectionFields/OptionTable.h>

#include <functional>
#include <map>

using namespace Checks;

namespace
{
using Settings = std::function<void(vtkDirectionField*)>;

/// All outputs are, byte by byte, those of a new filter with the same properties and a copy of the
/// input.
void CheckAsNew(vtkDirectionField* filter, vtkPolyData* input)
{
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(input);
  vtkNew<vtkDirectionField> fresh;
  fresh->SetInputData(copy);
#define COPY(name, ...) fresh->Set##name(filter->Get##name());
  DIRECTIONFIELDS_OPTIONS(COPY, COPY, COPY)
#undef COPY
  // Not the number of threads: bytes do not depend on it.
  fresh->SetNumberOfThreads(1);
  fresh->SetCellDirections(filter->GetCellDirections());
  fresh->SetGuidanceVectors(filter->GetGuidanceVectors());
  fresh->SetGuidanceWeights(filter->GetGuidanceWeights());
  fresh->SetGuidanceStrengths(filter->GetGuidanceStrengths());
  fresh->Update();
  REQUIRE(filter->GetOutput()->GetNumberOfPoints() > 0);
  CHECK(IsSame(filter->GetOutput()->GetPointData(), fresh->GetOutput()->GetPointData()));
  CHECK(IsSame(filter->GetOutput()->GetCellData(), fresh->GetOutput()->GetCellData()));
  CHECK(IsSame(filter->GetOutput()->GetFieldData(), fresh->GetOutput()->GetFieldData()));
  CHECK(IsSame(filter->GetOutput(1)->GetPointData(), fresh->GetOutput(1)->GetPointData()));
  CHECK(IsSame(
    filter->GetOutput()->GetPoints()->GetData(), fresh->GetOutput()->GetPoints()->GetData()));
}

PolyMeshes::Mesh WithVectors(PolyMeshes::Mesh mesh)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    vectors->InsertNextTuple3(1.0, 0.3, std::sin(static_cast<double>(i)));
  }
  mesh->GetPointData()->AddArray(vectors);
  return mesh;
}

/// The settings, each of which is made on top of the ones before it.
const std::vector<Settings> Changes = {
  [](vtkDirectionField*) {},
  [](vtkDirectionField* filter)
  { filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE); },
  [](vtkDirectionField* filter) { filter->SetAlignmentStrength(0.8); },
  [](vtkDirectionField* filter) { filter->ConstrainBoundaryOn(); },
  [](vtkDirectionField* filter) { filter->SetConstraintSolver(vtkDirectionField::LEAST_SQUARES); },
  [](vtkDirectionField* filter) { filter->SetDegree(2); },
  [](vtkDirectionField* filter)
  { filter->SetCurvatureDirection(vtkDirectionField::MINIMUM_CURVATURE); },
  [](vtkDirectionField* filter) { filter->SetCurvatureDirection(vtkDirectionField::MOST_BENT); },
  [](vtkDirectionField* filter) { filter->SetCurvatureScale(4.0); },
  [](vtkDirectionField* filter)
  {
    filter->ConstrainSharpEdgesOn();
    filter->SetFeatureAngle(6.0);
    filter->SetMinimumFeatureLength(0.1);
  },
  [](vtkDirectionField* filter) { filter->SetFeatureAngle(8.0); },
  [](vtkDirectionField* filter)
  {
    filter->ConstrainSharpEdgesOff();
    filter->ConstrainCurvatureOn();
    filter->SetCurvatureTolerance(0.4);
  },
  // With these limits there are constraints everywhere, also where they wind.
  [](vtkDirectionField* filter)
  {
    filter->SetCurvatureTolerance(0.0);
    filter->SetConsistencyAngle(180.0);
  },
  [](vtkDirectionField* filter) { filter->DropConstraintsAtSingularitiesOn(); },
  [](vtkDirectionField* filter) { filter->SetConsistencyAngle(10.0); },
  [](vtkDirectionField* filter)
  {
    filter->ConstrainCurvatureOff();
    filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
    filter->SetGuidanceVectors("vectors");
    filter->SetDegree(6);
  },
  [](vtkDirectionField* filter) { filter->SetEnergyBias(0.5); },
  [](vtkDirectionField* filter)
  {
    filter->UseShiftOn();
    filter->SetShift(7.0);
  },
  [](vtkDirectionField* filter) { filter->ConstrainBoundaryOff(); },
  [](vtkDirectionField* filter) { filter->SetTolerance(1e-9); },
  [](vtkDirectionField* filter) { filter->SetSolver(vtkDirectionField::SOLVER_MULTIGRID); },
  [](vtkDirectionField* filter) { filter->SetSolver(vtkDirectionField::SOLVER_DIRECT); },
  [](vtkDirectionField* filter)
  {
    filter->UnitLengthOn();
    filter->SetSingularityCost(1.5);
  },
  [](vtkDirectionField* filter)
  {
    filter->IntrinsicDelaunayOn();
    filter->CellDirectionsOn();
  },
  [](vtkDirectionField* filter)
  {
    filter->SetAlignment(vtkDirectionField::ALIGN_NONE);
    filter->SetDegree(4);
    filter->SetEnergyBias(0.0);
    filter->SetTolerance(1e-6);
    filter->IntrinsicDelaunayOff();
    filter->CellDirectionsOff();
  },
};

/// A stretched surface, so that some edges are not Delaunay, and open, so that it has a boundary.
vtkSmartPointer<vtkPolyData> StretchedSurface()
{
  auto mesh = WithVectors(PolyMeshes::Pebble(3));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    mesh->GetPoints()->SetPoint(i, 2.0 * p[0], p[1], p[2]);
  }
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName("vtkGhostType");
  hidden->SetNumberOfTuples(mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    mesh->GetCellBounds(i, bounds);
    hidden->SetValue(i, bounds[4] > 0.5 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  mesh->GetCellData()->AddArray(hidden);
  return mesh;
}

/// After every change the field is the one that a new filter computes.
void TestSettings()
{
  const auto mesh = StretchedSurface();
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  vtkNew<vtkDoubleArray> last;
  for (const Settings& change : Changes)
  {
    change(filter);
    filter->Update();
    CheckAsNew(filter, mesh);
    // The comparison means something only if each setting changes something.
    vtkDataArray* now = filter->GetOutput()->GetPointData()->GetArray("EnergyDensity");
    REQUIRE(now);
    CHECK(!IsSame(last, now));
    last->DeepCopy(now);

    // Settings of how the field is computed change nothing.
    const Settings ways[] = { [](vtkDirectionField* other) { other->SetNumberOfThreads(3); },
      [](vtkDirectionField* other) { other->KeepStagesOff(); },
      [](vtkDirectionField* other) { other->SetNumberOfThreads(1); },
      [](vtkDirectionField* other) { other->KeepStagesOn(); },
      [](vtkDirectionField* other) { other->ReleaseStages(); } };
    for (const Settings& way : ways)
    {
      way(filter);
      filter->Modified();
      filter->Update();
      CHECK(IsSame(last, filter->GetOutput()->GetPointData()->GetArray("EnergyDensity")));
    }
  }
}

/// A change of the input is noticed, however it is made.
void TestInput()
{
  auto mesh = WithVectors(PolyMeshes::Pebble(2));
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  const auto check = [&]
  {
    vtkNew<vtkDoubleArray> before;
    before->DeepCopy(filter->GetOutput()->GetPointData()->GetArray("RepresentationMagnitude"));
    filter->Update();
    CHECK(
      !IsSame(before, filter->GetOutput()->GetPointData()->GetArray("RepresentationMagnitude")));
    CheckAsNew(filter, mesh);
  };
  filter->Update();
  CheckAsNew(filter, mesh);

  // Points are moved in place, and then one of the objects that have them is told.
  mesh->GetPoints()->SetPoint(5, 1.4, 0.2, 0.1);
  mesh->Modified();
  check();
  mesh->GetPoints()->SetPoint(7, 0.1, 1.2, 0.1);
  mesh->GetPoints()->Modified();
  check();
  mesh->GetPoints()->SetPoint(9, 0.1, 0.2, 1.3);
  mesh->GetPoints()->GetData()->Modified();
  check();
  vtkNew<vtkPoints> points;
  points->DeepCopy(mesh->GetPoints());
  points->SetPoint(11, -1.0, 0.0, 0.3);
  mesh->SetPoints(points);
  check();

  // The same points get other cells, then some cells are hidden.
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 1; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    polys->InsertNextCell(ids);
  }
  mesh->SetPolys(polys);
  check();
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName("vtkGhostType");
  hidden->SetNumberOfTuples(mesh->GetNumberOfCells());
  hidden->FillValue(0);
  mesh->GetCellData()->AddArray(hidden);
  hidden->SetValue(160, vtkDataSetAttributes::HIDDENCELL);
  hidden->Modified();
  check();
  mesh->GetCellData()->RemoveArray("vtkGhostType");
  check();

  // Vertices before the polygons change the numbers of these, and nothing else.
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  mesh->SetVerts(verts);
  filter->Update();
  CheckAsNew(filter, mesh);

  // Guidance of the same name gets other values.
  filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
  filter->SetGuidanceVectors("vectors");
  filter->Update();
  mesh->GetPointData()->GetArray("vectors")->SetTuple3(3, 0.0, 5.0, 0.0);
  mesh->GetPointData()->GetArray("vectors")->Modified();
  check();

  // An error happens in between.
  mesh->GetPoints()->SetPoint(2, std::nan(""), 0.0, 0.0);
  mesh->GetPoints()->Modified();
  {
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->Update();
    CHECK(messages->IsOneError({ "point 2" }));
    filter->RemoveAllObservers();
  }
  mesh->GetPoints()->SetPoint(2, -1.0, -1.0, 0.5);
  mesh->GetPoints()->Modified();
  filter->Update();
  CheckAsNew(filter, mesh);
}

/// A change is noticed also at the end of arrays that are compared in pieces, and in each way of
/// storing them.
void TestLargeInput()
{
  auto mesh = PolyMeshes::Pebble(6);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  vtkIdType last = mesh->GetNumberOfPoints() - 1;
  const auto moveLast = [&](double by)
  {
    double point[3];
    mesh->GetPoint(last, point);
    mesh->GetPoints()->SetPoint(last, point[0] + by, point[1] + by, point[2]);
    mesh->GetPoints()->Modified();
  };
  const auto check = [&]
  {
    filter->Update();
    CheckAsNew(filter, mesh);
  };
  check();
  moveLast(1e-3);
  check();
  mesh->GetPolys()->ConvertTo32BitStorage();
  check();
  moveLast(1e-3);
  check();
  vtkNew<vtkPoints> precise;
  precise->SetDataTypeToDouble();
  precise->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(precise);
  check();
  moveLast(1e-12);
  check();
  last = 0;
  moveLast(1e-12);
  check();

  // An edge of the last triangle flipped: as many others of the same points. Then one less.
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> other;
  const vtkIdType triangle = mesh->GetNumberOfPolys() - 1;
  vtkCellArray* polys = mesh->GetPolys();
  polys->GetCellAtId(triangle, ids);
  const vtkIdType from = ids->GetId(0);
  const vtkIdType to = ids->GetId(1);
  const vtkIdType left = ids->GetId(2);
  for (vtkIdType i = 0; i < triangle; ++i)
  {
    polys->GetCellAtId(i, other);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      if (other->GetId(k) == to && other->GetId((k + 1) % 3) == from)
      {
        const vtkIdType right = other->GetId((k + 2) % 3);
        polys->ReplaceCellAtId(i, { from, right, left });
        polys->ReplaceCellAtId(triangle, { right, to, left });
      }
    }
  }
  polys->Modified();
  check();
  vtkNew<vtkCellArray> fewer;
  for (vtkIdType i = 0; i < triangle; ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    fewer->InsertNextCell(ids);
  }
  mesh->SetPolys(fewer);
  check();
}

/// The curvature is computed once, and outputs do not share it.
void TestCurvature()
{
  // Cut along an equator, where the points are there twice, so that MergePoints counts; where it is off,
  // the filters warn.
  vtkObject::GlobalWarningDisplayOff();
  auto mesh = PolyMeshes::Pebble(2, VTK_FLOAT);
  std::map<vtkIdType, vtkIdType> twins;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    double bounds[6];
    mesh->GetCellBounds(cell, bounds);
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; bounds[4] + bounds[5] > 0.0 && k < ids->GetNumberOfIds(); ++k)
    {
      double p[3];
      mesh->GetPoint(ids->GetId(k), p);
      const auto twin = twins.find(ids->GetId(k));
      ids->SetId(k,
        twin != twins.end() ? twin->second
                            : (twins[ids->GetId(k)] = mesh->GetPoints()->InsertNextPoint(p)));
    }
    polys->InsertNextCell(ids);
  }
  mesh->SetPolys(polys);
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  const auto check = [&]
  {
    filter->Update();
    CheckAsNew(filter, mesh);
    for (const char* name :
      { "PrincipalDirection0", "PrincipalDirection1", "MeanCurvature", "GaussianCurvature" })
    {
      vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
      REQUIRE(array);
      array->Fill(7.0);
    }
  };
  check();
  filter->SetAlignmentStrength(0.7);
  check();
  filter->SetDegree(2);
  check();
  filter->SetAlignment(vtkDirectionField::ALIGN_NONE);
  filter->Update();
  CHECK(!filter->GetOutput()->GetPointData()->GetArray("MeanCurvature"));
  filter->ConstrainCurvatureOn();
  filter->SetCurvatureTolerance(0.4);
  check();
  filter->MergePointsOn();
  check();
  filter->MergePointsOff();
  check();
  filter->SetMergePoints(vtkDirectionField::MERGE_POINTS_AUTOMATIC);
  check();

  // The points come at the same places in double precision.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(points);
  REQUIRE(mesh->GetPoints()->GetDataType() == VTK_DOUBLE);
  check();
  vtkObject::GlobalWarningDisplayOn();
}

/// Filters that take turns do not disturb each other.
void TestTwoFilters()
{
  auto mesh = PolyMeshes::Pebble(2);
  auto other = PolyMeshes::QuadTorus(20, 10);
  vtkNew<vtkDirectionField> one, two;
  one->SetInputData(mesh);
  two->SetInputData(mesh);
  two->SetDegree(2);
  for (const double strength : { 0.2, 0.6 })
  {
    for (vtkDirectionField* filter : { one.Get(), two.Get() })
    {
      filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
      filter->SetAlignmentStrength(strength);
      filter->Update();
    }
    CheckAsNew(one, mesh);
    CheckAsNew(two, mesh);
  }
  two->SetInputData(other);
  two->Update();
  one->SetAlignmentStrength(0.7);
  one->Update();
  CheckAsNew(one, mesh);
  CheckAsNew(two, other);
}
}

int TestDirectionFieldCache(int, char*[])
{
  TestSettings();
  TestInput();
  TestLargeInput();
  TestCurvature();
  TestTwoFilters();
  return Result();
}
