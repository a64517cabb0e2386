// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Run_h
#define Run_h

#include <DirectionFields/Progress.h>

#include <pybind11/pybind11.h>

#include <functional>

namespace py = pybind11;

namespace DirectionFields
{
/// Turns a result into what Python gets, with the interpreter's lock.
using Finish = std::function<py::object()>;

/// Runs a computation on a thread of its own, without the interpreter's lock, while the caller's
/// thread tells Python's function of the progress and looks for Ctrl-C every 50 milliseconds. What
/// either raises ends this call at once, and the computation behind it as soon as it asks whether
/// to go on: hence it must own all that it uses, and know nothing of Python.
/// @param progress None, or called with the fraction done, in the caller's thread
/// @param threads  number of threads; 0 for the default
py::object Run(
  const py::object& progress, int threads, std::function<Finish(const ProgressFunction&)> compute);

/// Stops all computations, some of which nobody may wait for any more, and waits for their ends and
/// for the threads that wait for them: the interpreter must not end before these.
void StopAll();
}

#endif
