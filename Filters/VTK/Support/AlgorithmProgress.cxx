// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/AlgorithmProgress.h"

#include "vtkAlgorithm.h"

namespace DirectionFields
{
bool IsAborted(vtkAlgorithm* algorithm)
{
#ifdef DIRECTIONFIELDS_VTK_HAS_CHECKABORT
  // CheckAbort notices a flag that was set with a time stamp only; the flag itself always counts.
  return algorithm->GetAbortExecute() || algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

ProgressFunction ReportTo(vtkAlgorithm* algorithm, double begin, double end)
{
  return [algorithm, begin, end](double done)
  {
    algorithm->UpdateProgress(begin + done * (end - begin));
    return !IsAborted(algorithm);
  };
}
}
