// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ProgressWatch_h
#define ProgressWatch_h

#include "Processes.h"

#include <functional>
#include <initializer_list>
#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace DirectionFields::Parallel
{
/// Lets one process run the work of a filter while the others wait: these report the progress 0
/// again and again, so that whoever looks at it can stop the filter there, too. All processes call
/// it; throws ProcessesError.
/// @param work      returns the error, empty for a stop, and whether there is none
/// @param isStopped whether somebody has asked the filter to stop
void ComputeOnOne(Processes& processes, int process, vtkAlgorithm* filter,
  const std::function<bool(std::string&)>& work, const std::function<bool()>& isStopped);

/// Runs the body of a filter; where it throws, reports the error and empties the outputs.
/// @return the result of RequestData: 1 also for a stop, which is no error
int RunTogether(vtkAlgorithm* filter, const std::function<void()>& body,
  std::initializer_list<vtkDataObject*> outputs);
}

#endif
