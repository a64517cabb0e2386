// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Duties of every filter in a pipeline: report its progress, stop where it is told to, and give the same bytes
// again.

#ifndef PipelineChecks_h
#define PipelineChecks_h

#include "Checks.h"

#include "vtkCallbackCommand.h"
#include "vtkPolyDataAlgorithm.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace PipelineChecks
{
/// Whether the text that a filter prints has all lines.
inline bool Prints(vtkObject* filter, std::initializer_list<const char*> lines)
{
  std::ostringstream text;
  filter->Print(text);
  return std::all_of(lines.begin(), lines.end(),
    [&](const char* line) { return text.str().find(line) != std::string::npos; });
}

using MakeFilter = std::function<vtkSmartPointer<vtkPolyDataAlgorithm>()>;

inline bool IsSameOutput(vtkPolyData* one, vtkPolyData* other)
{
  return one->GetNumberOfCells() == other->GetNumberOfCells() &&
    Checks::IsSame(one->GetPoints()->GetData(), other->GetPoints()->GetData()) &&
    Checks::IsSame(one->GetPointData(), other->GetPointData());
}

inline void CheckProgressAndAbort(const MakeFilter& make)
{
  std::vector<double> steps;
  vtkNew<vtkCallbackCommand> record;
  record->SetClientData(&steps);
  record->SetCallback([](vtkObject*, unsigned long, void* client, void* progress)
    { static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(progress)); });
  auto filter = make();
  filter->AddObserver(vtkCommand::ProgressEvent, record);
  filter->Update();
  CHECK(steps.size() >= 4);
  CHECK(std::is_sorted(steps.begin(), steps.end()));
  REQUIRE(!steps.empty());
  CHECK(steps.back() == 1.0);
  auto again = make();
  again->Update();
  CHECK(IsSameOutput(filter->GetOutput(), again->GetOutput()));

  for (const double when : { 0.0, 0.25 })
  {
    double limit = when;
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&limit);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void* progress)
      {
        if (*static_cast<double*>(progress) > *static_cast<double*>(client))
        {
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      });
    auto stopped = make();
    vtkNew<Checks::Messages> messages;
    messages->Observe(stopped);
    const unsigned long tag = stopped->AddObserver(vtkCommand::ProgressEvent, stop);
    stopped->Update();
    CHECK(messages->IsEmpty());
    CHECK(stopped->GetOutput()->GetNumberOfPoints() == 0);
    stopped->RemoveObserver(tag);
    stopped->SetAbortExecute(0);
    stopped->Modified();
    stopped->Update();
    CHECK(IsSameOutput(filter->GetOutput(), stopped->GetOutput()));
  }
}
}

#endif
