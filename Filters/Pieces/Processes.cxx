// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Processes.h"

#ifdef DIRECTIONFIELDS_HAVE_MPI
#include "vtkMPIController.h"
#endif

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <thread>

namespace DirectionFields::Parallel
{
namespace
{
/// How the work of a process ended, the worse the larger.
constexpr int Done = 0;
constexpr int WasStopped = 1;
constexpr int WasWrong = 2;

#ifdef DIRECTIONFIELDS_HAVE_MPI
constexpr int TagOfEnd = 4711;
constexpr int TagOfStop = 4712;
/// Between two looks of a waiting process.
constexpr std::chrono::milliseconds Pause(2);

/// Whether a message has arrived, which is taken then.
bool Take(vtkMPIController* controller, int from, int tag)
{
  int isThere = 0;
  int source = -1;
  if (controller->Iprobe(from, tag, &isThere, &source) && isThere)
  {
    int message = 0;
    controller->Receive(&message, 1, source, tag);
    return true;
  }
  return false;
}
#endif
}

std::vector<vtkIdType> Processes::AllGather(const std::vector<vtkIdType>& values)
{
  std::vector<vtkIdType> all(values.size() * static_cast<std::size_t>(this->Count()));
  this->Controller->AllGather(values.data(), all.data(), static_cast<vtkIdType>(values.size()));
  return all;
}

vtkIdType Processes::Largest(vtkIdType value)
{
  const std::vector<vtkIdType> all = this->AllGather({ value });
  return *std::max_element(all.begin(), all.end());
}

std::vector<vtkIdType> Processes::FirstOf(const std::vector<vtkIdType>& lengths)
{
  std::vector<vtkIdType> first(1, 0);
  for (const vtkIdType length : lengths)
  {
    first.push_back(first.back() + length);
  }
  return first;
}

void Processes::Scatter(const void* values, const std::vector<vtkIdType>& first, int components,
  int type, void* own, vtkIdType ownTuples, int from)
{
  std::vector<vtkIdType> begin = first;
  for (vtkIdType& value : begin)
  {
    value *= components;
  }
  std::vector<vtkIdType> lengths;
  for (std::size_t p = 0; p + 1 < begin.size(); ++p)
  {
    lengths.push_back(begin[p + 1] - begin[p]);
  }
  double none = 0.0;
  this->Controller->GetCommunicator()->ScatterVVoidArray(values ? values : &none, own ? own : &none,
    lengths.data(), begin.data(), ownTuples * components, type, from);
}

std::vector<vtkIdType> Processes::Scatter(const std::vector<vtkIdType>& values,
  const std::vector<vtkIdType>& first, vtkIdType count, int from)
{
  std::vector<vtkIdType> own;
  this->Together([&] { own.resize(static_cast<std::size_t>(count)); });
  this->Scatter(
    values.data(), first, 1, vtkTypeTraits<vtkIdType>::VTKTypeID(), own.data(), count, from);
  return own;
}

void Processes::ThrowTogether(
  int outcome, std::string error, vtkIdType asked, const std::function<void(vtkIdType)>& takeSum)
{
  const std::vector<vtkIdType> all = this->AllGather({ outcome, asked });
  std::vector<vtkIdType> outcomes;
  vtkIdType sum = 0;
  for (std::size_t k = 0; k < all.size(); k += 2)
  {
    outcomes.push_back(all[k]);
    sum += all[k + 1];
  }
  if (takeSum)
  {
    takeSum(sum);
  }
  const auto worst = std::max_element(outcomes.begin(), outcomes.end());
  if (*worst == Done)
  {
    return;
  }
  if (*worst == WasStopped)
  {
    throw ProcessesError("");
  }
  const int process = static_cast<int>(worst - outcomes.begin());
  auto length = static_cast<vtkIdType>(error.size());
  this->Controller->Broadcast(&length, 1, process);
  error.resize(static_cast<std::size_t>(length));
  if (length > 0)
  {
    this->Controller->Broadcast(&error[0], length, process);
  }
  throw ProcessesError(error.empty() ? std::string("The computation has failed.") : error);
}

void Processes::Together(const std::function<void()>& work, const std::string& remedy)
{
  int outcome = Done;
  std::string error;
  try
  {
    work();
  }
  catch (const ProcessesError& stopped)
  {
    error = stopped.what();
    outcome = error.empty() ? WasStopped : WasWrong;
  }
  catch (const std::bad_alloc&)
  {
    outcome = WasWrong;
    error = remedy + ": there is too little memory on process " + std::to_string(this->Own()) + ".";
  }
  catch (const std::exception& exception)
  {
    outcome = WasWrong;
    error = exception.what() + (" (On process " + std::to_string(this->Own()) + ".)");
  }
  this->ThrowTogether(outcome, error);
}

void Processes::OnOne(int process, const std::function<bool(std::string&)>& work,
  const std::function<bool()>& goOn, const std::function<void()>& stop,
  const std::function<void(const std::function<void()>&)>& watch)
{
  std::string error;
  int outcome = Done;
  const auto run = [&]
  {
    if (!work(error))
    {
      outcome = error.empty() ? WasStopped : WasWrong;
    }
  };
#ifdef DIRECTIONFIELDS_HAVE_MPI
  if (auto* const mpi = vtkMPIController::SafeDownCast(this->Controller))
  {
    int message = 0;
    if (this->Own() != process)
    {
      vtkIdType asked = 0;
      while (!Take(mpi, process, TagOfEnd))
      {
        std::this_thread::sleep_for(Pause);
        if (asked == 0 && !goOn())
        {
          mpi->Send(&message, 1, process, TagOfStop);
          asked = 1;
        }
      }
      this->ThrowTogether(outcome, error, asked);
      return;
    }
    vtkIdType taken = 0;
    watch(
      [&]
      {
        if (Take(mpi, vtkMultiProcessController::ANY_SOURCE, TagOfStop))
        {
          ++taken;
          stop();
        }
      });
    run();
    for (int p = 0; p < this->Count(); ++p)
    {
      if (p != process)
      {
        mpi->Send(&message, 1, p, TagOfEnd);
      }
    }
    // Who asked too late must not be heard in the next run.
    const auto takeRest = [&](vtkIdType asked)
    {
      for (; taken < asked; ++taken)
      {
        mpi->Receive(&message, 1, vtkMultiProcessController::ANY_SOURCE, TagOfStop);
      }
    };
    this->ThrowTogether(outcome, error, 0, takeRest);
    return;
  }
#endif
  (void)goOn;
  (void)stop;
  (void)watch;
  if (this->Own() == process)
  {
    run();
  }
  this->ThrowTogether(outcome, error);
}
}
