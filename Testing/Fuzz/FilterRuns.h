// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FilterRuns_h
#define DirectionFields_FilterRuns_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

/// Statements that hold for every filter, whatever its input is.
namespace FilterRuns
{
using MeshPointer = vtkSmartPointer<vtkPolyData>;

struct Filter
{
  /// A new one with all options set, without inputs.
  std::function<vtkSmartPointer<vtkPolyDataAlgorithm>()> Make;
  /// One for each input port; null where an optional one is missing.
  std::vector<MeshPointer> Inputs;
};

struct Outcome
{
  /// The first statement that does not hold; empty if all do.
  std::string Flaw;
  /// The filter's error; empty if it had none.
  std::string Error;
  std::vector<MeshPointer> Outputs;
};

/// Executes a filter on one thread. An error is one sentence and leaves nothing; without one all
/// numbers are finite that the filter has made. The inputs stay as they were.
Outcome Execute(const Filter& filter);

/// The difference, if there is any, of another execution by a filter that has first had other
/// inputs; of one by a new filter on two threads.
std::string FlawOfSecondUse(const Filter& filter, const Outcome& outcome);
std::string FlawOnTwoThreads(const Filter& filter, const Outcome& outcome);
}

#endif
