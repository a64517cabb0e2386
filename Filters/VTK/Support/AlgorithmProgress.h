// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef AlgorithmProgress_h
#define AlgorithmProgress_h

#include <DirectionFields/Progress.h>

class vtkAlgorithm;

namespace DirectionFields
{
/// Whether someone asked an algorithm, or one before it in the pipeline, to stop.
bool IsAborted(vtkAlgorithm* algorithm);

/// A function that reports the fraction done of a part of an algorithm to the algorithm's
/// observers, and returns false where someone asked it to stop.
/// @param begin, end the fractions of the whole at which the part begins and ends
ProgressFunction ReportTo(vtkAlgorithm* algorithm, double begin = 0.0, double end = 1.0);
}

#endif
