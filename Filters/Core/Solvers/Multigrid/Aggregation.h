// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Aggregation_h
#define DirectionFields_Aggregation_h

#include "Solvers/Multigrid/Coarsening.h"

#include <vector>

namespace DirectionFields
{
/// How much each entry couples after transport, the diagonal's unit taken out of it; 0 if weakly.
struct Couplings
{
  LargeArray<float> Strength;
  /// Diagonal of the energy with the weak couplings lumped into it.
  LargeArray<float> Diagonal;
};

/// @param level 0 for the finest
Couplings FindCouplings(const LevelMatrices& matrices, int level);

/// The aggregate of each vertex, None where it was left out, and its value where the aggregate's root
/// has 1.
struct Aggregates
{
  LargeArray<Index> Number;
  LargeArray<CompactComplex> Phase;
  Index Count = 0;
};

/// Whole neighbourhoods of strong couplings, first come, first served; what is left over joins them.
Aggregates Aggregate(
  const LevelMatrices& matrices, const Couplings& couplings, LeftOver leftOver);
}

#endif
