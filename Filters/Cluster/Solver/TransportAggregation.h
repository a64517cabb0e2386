// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef TransportAggregation_h
#define TransportAggregation_h

#include "Solver/PetscObjects.h"

namespace DirectionFields::Parallel
{
/// The prolongator of smoothed aggregation over rows on several processes: LinearAlgebra's
/// aggregates of each process's own rows, whose sections are transported from their roots, smoothed
/// by the whole energy.
///
/// All processes call it; throws ProcessesError and std::runtime_error on all of them.
/// @param energy, mass as in Operators, of the same pattern
/// @param level 0 for the finest
OwnedMat MakeProlongator(Mat energy, Mat mass, int level);
}

#endif
