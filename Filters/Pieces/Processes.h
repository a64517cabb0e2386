// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Processes_h
#define Processes_h

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"
#include "vtkTypeTraits.h"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
/// Ends the work of all processes: the error of one of them, or that someone asked it to stop.
class ProcessesError : public std::runtime_error
{
public:
  /// @param error a sentence for the user; empty where the work was stopped
  explicit ProcessesError(const std::string& error)
    : std::runtime_error(error)
  {
  }
};

/// The processes that work on one surface. Every function but Count and Own must be called by all
/// of them in the same order, also by processes without points.
class Processes
{
public:
  /// @param controller of at least two processes; must live on
  explicit Processes(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  int Count() const { return this->Controller->GetNumberOfProcesses(); }
  int Own() const { return this->Controller->GetLocalProcessId(); }

  /// Does work of each process's own, which must not communicate. Where it throws on any of them
  /// all throw the same ProcessesError: that of the first process with an error.
  /// @param remedy advice to the user where there is too little memory, the beginning of a sentence
  void Together(const std::function<void()>& work,
    const std::string& remedy = "Take more nodes of a cluster, or decimate the surface");

  /// Does work on one process while the others wait without taking processor time from it.
  /// @param work returns the error as ProcessesError has it, and whether there is none
  /// @param goOn is called on the waiting processes now and then; false asks the working one to
  /// stop
  /// @param stop is called on the working process where another one asks for it
  /// @param watch makes the working process look for that: hands over a function to be called now
  /// and then
  void OnOne(int process, const std::function<bool(std::string&)>& work,
    const std::function<bool()>& goOn, const std::function<void()>& stop,
    const std::function<void(const std::function<void()>&)>& watch);

  /// The numbers of all processes, which give equally many, in the order of the processes.
  std::vector<vtkIdType> AllGather(const std::vector<vtkIdType>& values);
  vtkIdType Largest(vtkIdType value);

  /// Brings the values of all processes to one. Needs no agreement: whoever gathers has made room
  /// for them.
  /// @param own     this process's values, of one number for each of lengths
  /// @param lengths how many each process has, known everywhere
  template <typename T>
  void Gather(
    const std::vector<T>& own, std::vector<vtkIdType> lengths, std::vector<T>& all, int to)
  {
    std::vector<vtkIdType> first = FirstOf(lengths);
    // The functions of VTK take no null pointers for empty arrays.
    T none[1] = {};
    this->Controller->GetCommunicator()->GatherVVoidArray(own.empty() ? none : own.data(),
      all.empty() ? none : all.data(), static_cast<vtkIdType>(own.size()), lengths.data(),
      first.data(), vtkTypeTraits<T>::VTKTypeID(), to);
  }

  /// Brings each process its part of values that one process has.
  /// @param values    of tuples, for all processes; only read on the process `from`
  /// @param first     the first tuple of each process, and the number of all; only read there
  /// @param type      VTK's number of the values' type
  /// @param own       has room for ownTuples tuples
  void Scatter(const void* values, const std::vector<vtkIdType>& first, int components, int type,
    void* own, vtkIdType ownTuples, int from);

  /// The same for numbers. Here room is made on all processes.
  std::vector<vtkIdType> Scatter(const std::vector<vtkIdType>& values,
    const std::vector<vtkIdType>& first, vtkIdType count, int from);

  /// The place of each process's first number where the lengths are given, and the number of all.
  static std::vector<vtkIdType> FirstOf(const std::vector<vtkIdType>& lengths);

  vtkMultiProcessController* GetController() const { return this->Controller; }

private:
  /// Throws where any process has an error.
  /// @param outcome 0 for none, 1 for a stop, 2 for an error
  /// @param takeSum gets the sum of the processes' `asked`, before any error
  void ThrowTogether(int outcome, std::string error, vtkIdType asked = 0,
    const std::function<void(vtkIdType)>& takeSum = {});

  vtkMultiProcessController* Controller;
};
}

#endif
