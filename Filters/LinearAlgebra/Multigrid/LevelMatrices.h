// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LevelMatrices_h
#define DirectionFields_LevelMatrices_h

#include "Matrices/Operators.h"
#include "Multigrid/CompactMatrix.h"

namespace DirectionFields::Internal
{
/// Energy and mass matrix of one level of a multigrid hierarchy; they have the same pattern.
struct LevelMatrices
{
  CompactMatrix Energy;
  /// The mass matrix' off-diagonal entries, in the order of Energy.Value.
  LargeArray<CompactComplex> MassValue;
  LargeArray<float> MassDiagonal;

  /// ax = A x and mx = M x in one pass.
  template <int B>
  void Multiply(const float* x, float* ax, float* mx) const;
};

/// ax = A x and mx = M x for four sections in single precision (see CompactSections). The sums of A
/// x are in double precision.
void Multiply(const Operators& operators, const float* x, float* ax, float* mx);
}

#endif
