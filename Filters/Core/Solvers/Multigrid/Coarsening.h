// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Coarsening_h
#define DirectionFields_Coarsening_h

#include "Solvers/Multigrid/CompactMatrix.h"

namespace DirectionFields
{
/// Energy and mass matrix of one level of a multigrid hierarchy; they have the same pattern.
struct LevelMatrices
{
  CompactMatrix Energy;
  /// Off-diagonal entries at the places of Energy's.
  LargeArray<CompactComplex> MassValue;
  LargeArray<float> MassDiagonal;

  /// ax = A x and mx = M x in one pass.
  template <int B>
  void Multiply(const float* x, float* ax, float* mx) const;
};

/// Interpolates a section of the next coarser level, row by row, and its adjoint.
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
};

/// What becomes of vertices that couple with no others strongly. Sweeps solve for those whose diagonal
/// outweighs all couplings, as between given values: if coarse levels keep them they hardly get
/// smaller in the end. Yet for eigenvectors a coarse level must be able to hold any section.
enum class LeftOver
{
  Keep,
  Drop
};

/// Smoothed aggregation (P. Vaněk, J. Mandel, M. Brezina, Computing 56, 1996) that knows the
/// transport of sections: neighbouring vertices are aggregated where the energy couples their values
/// after transport strongly and with the right sign, and a section of the coarse level is
/// transported from each aggregate's root to the others before it is smoothed.
///
/// Then a step lowers the energy of each column where it stands (J. Mandel, M. Brezina, P. Vaněk,
/// Computing 62, 1999): a quarter fewer cycles with matrices that are no denser.
///
/// The transport is that of the mass matrix: the phases of its entries, unlike the energy's, do not
/// change where a cotangent weight is negative.
/// @param level 0 for the finest: what counts as strong gets weaker from level to level
Prolongator MakeProlongator(const LevelMatrices& matrices, int level, LeftOver leftOver);

/// P^* A P and P^* M P.
LevelMatrices Coarsen(const LevelMatrices& matrices, const Prolongator& prolongator);
}

#endif
