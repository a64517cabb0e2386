// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Aggregation_h
#define DirectionFields_Aggregation_h

#include "Multigrid/LevelMatrices.h"

#include <vector>

namespace DirectionFields::Internal
{
/// How strongly the energy couples vertices.
struct Couplings
{
  /// For each entry A_ij of the energy: -Re A_ij conj(r_ij), where r_ij is the transport from j to
  /// i, or 0 where the coupling is weak.
  LargeArray<float> Strength;
  /// The energy's diagonal with the weak couplings lumped into it.
  LargeArray<float> Diagonal;
};

/// @param level 0 for the finest
Couplings FindCouplings(const LevelMatrices& matrices, int level);

struct Aggregates
{
  /// The aggregate of each vertex; None where the vertex was left out.
  LargeArray<Index> Number;
  /// The value at each vertex of the section that is 1 at the aggregate's root and transported from
  /// there.
  LargeArray<CompactComplex> Phase;
  Index Count = 0;
};

/// The treatment of vertices without strong couplings.
enum class LeftOver
{
  /// Each becomes an aggregate: for eigenvectors a coarse level must be able to hold any section.
  Keep,
  /// Those whose diagonal outweighs all couplings, as between given values, are left out: sweeps
  /// solve for them. Coarse levels that keep them consist of little else in the end, and hardly get
  /// smaller.
  Drop
};

/// Aggregates are whole neighbourhoods of strong couplings, first come, first served; the vertices
/// between them join one.
Aggregates Aggregate(const LevelMatrices& matrices, const Couplings& couplings, LeftOver leftOver);
}

#endif
