// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/FilterRun.h"

#include "Progress.h"

#include "vtkDataObject.h"

#include <exception>
#include <new>

namespace DirectionFields
{
bool RunFilter(const std::function<void()>& body, std::initializer_list<vtkDataObject*> outputs,
  std::string& error, const char* remedy)
{
  bool isWrong = true;
  try
  {
    body();
    return true;
  }
  catch (const Stopped&)
  {
    isWrong = false;
  }
  catch (const std::bad_alloc&)
  {
    error = std::string(remedy) + ": there is too little memory.";
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  for (vtkDataObject* output : outputs)
  {
    output->Initialize();
  }
  return !isWrong;
}
}
