// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Prolongator_h
#define DirectionFields_Prolongator_h

#include "Multigrid/CompactMatrix.h"

namespace DirectionFields::Internal
{
/// The matrix P that interpolates a section of the next coarser level, by rows, and its adjoint
/// P^*, which takes residuals to that level.
struct Prolongator
{
  LargeArray<Index> Begin;
  LargeArray<Index> Column;
  LargeArray<CompactComplex> Value;
  LargeArray<Index> AdjointBegin;
  LargeArray<Index> AdjointColumn;
  LargeArray<CompactComplex> AdjointValue;

  Index FineRows() const { return static_cast<Index>(this->Begin.size()) - 1; }
  Index CoarseRows() const { return static_cast<Index>(this->AdjointBegin.size()) - 1; }

  /// x = P y
  template <int B>
  void Prolong(const float* y, float* x) const;
  /// x += P y
  template <int B>
  void AddTo(float* x, const float* y) const;
  /// y = P^* x
  template <int B>
  void Restrict(const float* x, float* y) const;

  /// Fills in the adjoint, its rows in ascending order of the fine vertices.
  /// @param coarse the number of columns
  void AddAdjoint(Index coarse);
};
}

#endif
