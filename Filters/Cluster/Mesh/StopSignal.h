// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef StopSignal_h
#define StopSignal_h

#include "Mesh/Messages.h"

#include <chrono>
#include <functional>
#include <thread>

namespace DirectionFields::Parallel
{
/// Tells processes that work by themselves that another one has been stopped or has failed, so that
/// none works on for nothing. All messages have arrived once Finish returns.
class StopSignal
{
public:
  explicit StopSignal(const Messages& messages)
    : Exchange(messages)
  {
  }
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  void Raise()
  {
    for (int p = 0; p < this->Exchange.Count() && !this->HasRaised; ++p)
    {
      if (p != this->Exchange.Own())
      {
        // Nothing is sent but the message itself, which never waits for its receiver.
        MPI_Send(nullptr, 0, MPI_BYTE, p, Tag, this->Exchange.GetCommunicator());
      }
    }
    this->HasRaised = true;
  }

  /// Whether another process has raised it.
  bool IsRaised()
  {
    int isThere = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, Tag, this->Exchange.GetCommunicator(), &isThere, MPI_STATUS_IGNORE);
    if (isThere)
    {
      this->Take();
    }
    return this->Taken > 0;
  }

  /// Waits for the end of the others' work, without taking processor time from them. All processes
  /// call it, and then Finish.
  /// @param goOn is called now and then; false raises the signal
  /// @return whether goOn never was false
  bool WaitForAll(const std::function<bool()>& goOn)
  {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(this->Exchange.GetCommunicator(), &request);
    bool goesOn = true;
    for (;;)
    {
      int isDone = 0;
      MPI_Test(&request, &isDone, MPI_STATUS_IGNORE);
      if (isDone)
      {
        return goesOn;
      }
      if (goesOn && !goOn())
      {
        goesOn = false;
        this->Raise();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  /// All processes call it, each when it has come to its end.
  void Finish()
  {
    const double others =
      this->Exchange.Sum(this->HasRaised ? 1.0 : 0.0) - (this->HasRaised ? 1.0 : 0.0);
    while (this->Taken < static_cast<int>(others))
    {
      this->Take();
    }
  }

private:
  static constexpr int Tag = 4714;

  void Take()
  {
    MPI_Recv(nullptr, 0, MPI_BYTE, MPI_ANY_SOURCE, Tag, this->Exchange.GetCommunicator(),
      MPI_STATUS_IGNORE);
    ++this->Taken;
  }

  const Messages& Exchange;
  bool HasRaised = false;
  int Taken = 0;
};
}

#endif
