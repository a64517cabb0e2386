// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Running/ProgressWatch.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"

#include <exception>

namespace DirectionFields::Parallel
{
namespace
{
void CallBack(vtkObject*, unsigned long, void* look, void*)
{
  (*static_cast<const std::function<void()>*>(look))();
}
}

void ComputeOnOne(Processes& processes, int process, vtkAlgorithm* filter,
  const std::function<bool(std::string&)>& work, const std::function<bool()>& isStopped)
{
  std::function<void()> look;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(CallBack);
  command->SetClientData(&look);
  unsigned long observer = 0;
  const auto watch = [&](const std::function<void()>& wanted)
  {
    look = wanted;
    observer = filter->AddObserver(vtkCommand::ProgressEvent, command);
  };
  const auto goOn = [&]
  {
    filter->UpdateProgress(0.0);
    return !isStopped();
  };
  bool wasStoppedByOthers = false;
  const auto stop = [&]
  {
    filter->SetAbortExecute(1);
    wasStoppedByOthers = true;
  };
  const auto workWatched = [&](std::string& error)
  {
    const bool isRight = work(error);
    if (observer != 0)
    {
      filter->RemoveObserver(observer);
    }
    if (wasStoppedByOthers)
    {
      // Whoever has asked takes it back there, not here.
      filter->SetAbortExecute(0);
    }
    return isRight;
  };
  processes.OnOne(process, workWatched, goOn, stop, watch);
}

int RunTogether(vtkAlgorithm* filter, const std::function<void()>& body,
  std::initializer_list<vtkDataObject*> outputs)
{
  std::string error;
  try
  {
    body();
    filter->UpdateProgress(1.0);
    return 1;
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  for (vtkDataObject* const output : outputs)
  {
    output->Initialize();
  }
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(filter, << error);
    return 0;
  }
  return 1;
}
}
