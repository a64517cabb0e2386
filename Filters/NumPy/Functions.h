// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Functions_h
#define Functions_h

#include "Arrays.h"
#include "Keywords.h"
#include "Run.h"

namespace DirectionFields
{
/// Stores what a function takes by keyword.
template <class Read>
void Describe(py::dict& described, const char* function, Read* read)
{
  Keywords keywords(function, py::dict());
  read(keywords);
  described[function] = keywords.Described;
}

/// The names of the values of TensorDirection, from 0.
inline Keywords::Names TensorDirectionNames()
{
  return { "major", "minor", "larger_magnitude" };
}

/// Adds the functions that draw on surfaces with a field, remesh, guide and compare.
void AddDrawing(py::module_& module, py::dict& described);
}

#endif
