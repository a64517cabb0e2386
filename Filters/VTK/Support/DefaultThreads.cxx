// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/DefaultThreads.h"

#include <DirectionFields/Support/Threads.h>

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace DirectionFields
{
int DefaultThreads()
{
  if (std::strcmp(vtkSMPTools::GetBackend(), "Sequential") != 0)
  {
    return vtkSMPTools::GetEstimatedNumberOfThreads();
  }
  // VTK's default backend has one thread only, which does not tell the user's wish.
  const char* most = std::getenv("VTK_SMP_MAX_THREADS");
  const int number = most ? std::atoi(most) : 0;
  return number > 0 ? std::min(number, Threads::GetDefaultNumber()) : 0;
}
}
