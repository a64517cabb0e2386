// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Aggregation_h
#define DirectionFields_Aggregation_h

#include "Solvers/Multigrid/LevelMatrices.h"

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

/// What becomes of vertices that couple with no others strongly. Sweeps solve for those whose diagonal
/// outweighs all couplings, as between given values: if coarse levels keep them they hardly get
/// smaller in the end. Yet for eigenvectors a coarse level must be able to hold any section.
enum class LeftOver
{
  Keep,
  Drop
};

/// Whole neighbourhoods of strong couplings, first come, first served; what is left over joins them.
Aggregates Aggregate(
  const LevelMatrices& matrices, const Couplings& couplings, LeftOver leftOver);
}

#endif
