// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The data that a filter keeps from run to run save time.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"

using namespace Checks;

/// The eigenvalue problem is not solved again for another strength, nor for an array more: its
/// progress is not heard of.
int TestDirectionFieldSaving(int, char*[])
{
  auto mesh = PolyMeshes::Pebble(3);
  int solving = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&solving);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* progress)
    {
      const double done = *static_cast<double*>(progress);
      *static_cast<int*>(client) += done > 0.1 && done < 0.55 ? 1 : 0;
    });
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(mesh);
  filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  filter->AddObserver(vtkCommand::ProgressEvent, count);
  filter->Update();
  CHECK(solving >= 3);

  const auto check = [&](bool solves)
  {
    solving = 0;
    filter->Update();
    CHECK((solving > 0) == solves);
  };
  filter->SetAlignmentStrength(0.9);
  check(false);
  filter->ConstrainCurvatureOn();
  filter->SetCurvatureTolerance(0.5);
  check(false);
  vtkNew<vtkDoubleArray> more;
  more->SetName("more");
  more->SetNumberOfTuples(mesh->GetNumberOfPoints());
  more->Fill(0.0);
  mesh->GetPointData()->AddArray(more);
  check(false);
  mesh->Modified();
  check(false);
  filter->SetDegree(2);
  check(true);
  mesh->GetPoints()->SetPoint(0, 1.0, 1.0, 0.0);
  mesh->GetPoints()->Modified();
  check(true);
  return Result();
}
