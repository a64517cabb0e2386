// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FilterRun_h
#define FilterRun_h

#include <functional>
#include <initializer_list>
#include <string>

class vtkDataObject;

namespace DirectionFields
{
/// Runs the body of a filter and empties its outputs where it does not come to its end.
/// @param error  what was wrong, as a sentence for the user
/// @param remedy what the user can do where there is too little memory, as the sentence's beginning
/// @return false for an error; a filter that was stopped has none
bool RunFilter(const std::function<void()>& body, std::initializer_list<vtkDataObject*> outputs,
  std::string& error, const char* remedy = "Decimate the surface or process it in parts");
}

#endif
