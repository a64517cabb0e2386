// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SmoothedAggregation_h
#define DirectionFields_SmoothedAggregation_h

#include "Multigrid/Aggregation.h"
#include "Multigrid/Prolongator.h"

namespace DirectionFields::Internal
{
/// Smoothed aggregation (P. Vaněk, J. Mandel, M. Brezina, Computing 56, 1996) that knows the
/// transport of sections: neighbouring vertices are aggregated where the energy couples their
/// values after transport strongly and with the right sign, and a section of the coarse level is
/// transported from each aggregate's root to the others before it is smoothed.
///
/// Then a step lowers the energy of each column within its pattern (J. Mandel, M. Brezina, P.
/// Vaněk, Computing 62, 1999): solvers take a quarter fewer cycles, with matrices that are no
/// denser.
///
/// The transport is the phase of the mass matrix' entries: unlike the energy's, they do not change
/// sign where a cotangent weight is negative.
/// @param level 0 for the finest: the threshold of strong couplings falls from level to level
Prolongator MakeProlongator(const LevelMatrices& matrices, int level, LeftOver leftOver);
}

#endif
