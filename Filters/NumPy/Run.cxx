// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Run.h"

#include <DirectionFields/Support/Threads.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr std::chrono::milliseconds BetweenLooks(50);

/// The computations that run, and the threads of Python that wait for them.
struct Running
{
  std::mutex Mutex;
  std::condition_variable Changed;
  int Number = 0;
  std::atomic<bool> AreToStop{ false };

  void Add(int number)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Number += number;
    this->Changed.notify_all();
  }
};

Running& GetRunning()
{
  // Threads may outlive what is destroyed when the program ends.
  static auto* const running = new Running();
  return *running;
}

/// The state that the two threads of a computation share.
struct Task
{
  std::mutex Mutex;
  std::condition_variable Changed;
  double Done = 0.0;
  bool HasNews = false;
  bool IsToStop = false;
  bool IsFinished = false;
  Finish Result;
  std::exception_ptr Error;

  bool Report(double fraction)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->HasNews = this->HasNews || fraction > this->Done;
    this->Done = std::max(fraction, this->Done);
    if (this->HasNews)
    {
      this->Changed.notify_one();
    }
    return !this->IsToStop && !GetRunning().AreToStop;
  }
};

void Compute(Task& task, int number, const std::function<Finish(const ProgressFunction&)>& compute)
{
  Finish result;
  std::exception_ptr error;
  try
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    result = compute([&task](double fraction) { return task.Report(fraction); });
  }
  catch (...)
  {
    error = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(task.Mutex);
  task.Result = std::move(result);
  task.Error = std::move(error);
  task.IsFinished = true;
  task.Changed.notify_one();
}

/// Returns when the computation is finished. Throws what Python raises.
void Attend(Task& task, const py::object& progress)
{
  const bool listens = !progress.is_none();
  for (bool isFinished = false; !isFinished;)
  {
    double done = 0.0;
    bool hasNews = false;
    {
      const py::gil_scoped_release unlocked;
      std::unique_lock<std::mutex> lock(task.Mutex);
      task.Changed.wait_for(
        lock, BetweenLooks, [&] { return task.IsFinished || (listens && task.HasNews); });
      isFinished = task.IsFinished;
      done = task.Done;
      hasNews = std::exchange(task.HasNews, false);
    }
    if (listens && hasNews)
    {
      progress(done);
    }
    if (PyErr_CheckSignals() != 0)
    {
      throw py::error_already_set();
    }
  }
}
}

py::object Run(
  const py::object& progress, int threads, std::function<Finish(const ProgressFunction&)> compute)
{
  if (GetRunning().AreToStop)
  {
    throw std::runtime_error("Python ends: nothing is computed any more.");
  }
  const auto task = std::make_shared<Task>();
  std::thread(
    [task, threads, compute = std::move(compute)]() mutable
    {
      Compute(*task, threads, compute);
      compute = nullptr;
      GetRunning().Add(-1);
    })
    .detach();
  GetRunning().Add(2);
  const std::unique_ptr<Running, void (*)(Running*)> waiting(
    &GetRunning(), [](Running* running) { running->Add(-1); });
  try
  {
    Attend(*task, progress);
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> lock(task->Mutex);
    task->IsToStop = true;
    throw;
  }
  if (GetRunning().AreToStop)
  {
    throw std::runtime_error("Python ends: the computation was stopped.");
  }
  if (task->Error)
  {
    std::rethrow_exception(task->Error);
  }
  return std::exchange(task->Result, nullptr)();
}

void StopAll()
{
  const py::gil_scoped_release unlocked;
  Running& running = GetRunning();
  running.AreToStop = true;
  std::unique_lock<std::mutex> lock(running.Mutex);
  running.Changed.wait(lock, [&running] { return running.Number <= 0; });
}
}
