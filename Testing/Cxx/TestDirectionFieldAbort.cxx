// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whichever report of the progress is answered by an abort, it is the last, the outputs are empty, and
// the next run is complete.

#include "Checks.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"

#include "vtkCallbackCommand.h"

using namespace Checks;

namespace
{
struct Watch
{
  /// The number of the report that is answered by an abort, or -1 for none.
  int When = -1;
  std::vector<double> Reports;

  static void Report(vtkObject* caller, unsigned long, void* client, void* progress)
  {
    auto self = static_cast<Watch*>(client);
    if (static_cast<int>(self->Reports.size()) == self->When)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
    self->Reports.push_back(*static_cast<double*>(progress));
  }
};

/// Whether nothing was reported after the abort except for the end, which the pipeline reports.
bool IsLast(const Watch& watch)
{
  const auto after = static_cast<int>(watch.Reports.size()) - watch.When - 1;
  return after == 0 || (after == 1 && watch.Reports.back() == 1.0);
}

/// make() gives a filter with all its settings and its input.
template <typename Make>
void TestEveryReport(const Make& make, size_t least)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Watch::Report);
  Watch all;
  auto complete = make();
  command->SetClientData(&all);
  complete->AddObserver(vtkCommand::ProgressEvent, command);
  complete->Update();
  const auto count = static_cast<int>(all.Reports.size());
  CHECK(all.Reports.size() >= least);
  REQUIRE(complete->GetOutput()->GetNumberOfPoints() > 0);

  // All runs are those of one filter, as in an application.
  auto filter = make();
  vtkNew<Messages> messages;
  messages->Observe(filter);
  // The pipeline makes the first report, of 0, before the filter gets to work.
  for (int when = 1; when < count && all.Reports[static_cast<size_t>(when)] < 1.0; ++when)
  {
    Watch watch;
    watch.When = when;
    command->SetClientData(&watch);
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
    filter->Modified();
    filter->Update();
    filter->RemoveObserver(tag);
    filter->SetAbortExecute(0);
    // Runs after the first one find stages that an abort left complete, hence they report less.
    if (static_cast<int>(watch.Reports.size()) <= when)
    {
      break;
    }
    CHECK(IsLast(watch));
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      auto output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
      CHECK(output->GetNumberOfPoints() == 0);
      CHECK(output->GetNumberOfCells() == 0);
      CHECK(output->GetPointData()->GetNumberOfArrays() == 0);
      CHECK(output->GetFieldData()->GetNumberOfArrays() == 0);
    }
    // A new filter has everything to do.
    auto fresh = make();
    Watch again;
    again.When = when;
    command->SetClientData(&again);
    fresh->AddObserver(vtkCommand::ProgressEvent, command);
    fresh->Update();
    CHECK(IsLast(again));
    CHECK(fresh->GetOutput()->GetNumberOfPoints() == 0);
  }
  filter->Modified();
  filter->Update();
  CHECK(messages->IsEmpty());
  CHECK(IsSame(filter->GetOutput()->GetCellData(), complete->GetOutput()->GetCellData()));
  CHECK(IsSame(
    filter->GetOutput()->GetPoints()->GetData(), complete->GetOutput()->GetPoints()->GetData()));
}
}

int TestDirectionFieldAbort(int, char*[])
{
  const auto field = []
  {
    auto filter = vtkSmartPointer<vtkDirectionField>::New();
    filter->SetInputData(PolyMeshes::Pebble(3));
    return filter;
  };
  TestEveryReport(field, 15);
  TestEveryReport(
    [&field]
    {
      auto filter = field();
      filter->SetInputData(
        PolyMeshes::BesideEachOther(PolyMeshes::Pebble(3), PolyMeshes::QuadTorus(20, 10), 4.0));
      filter->SetDegree(2);
      filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
      filter->ConstrainCurvatureOn();
      filter->SetConstraintSolver(vtkDirectionField::ENERGY);
      return filter;
    },
    20);
  auto source = field();
  source->Update();
  TestEveryReport(
    [&source]
    {
      auto filter = vtkSmartPointer<vtkDirectionFieldGlyphs>::New();
      filter->SetInputData(source->GetOutput());
      // Fewer are laid out in one report or two.
      filter->SetMaximumNumberOfGlyphs(2000);
      return filter;
    },
    10);
  TestEveryReport(
    [&source]
    {
      auto filter = vtkSmartPointer<vtkDirectionFieldSingularities>::New();
      filter->SetInputConnection(source->GetOutputPort());
      filter->SetSingularitiesConnection(source->GetOutputPort(1));
      return filter;
    },
    5);
  return Result();
}
