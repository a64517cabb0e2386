// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompactMatrix_h
#define DirectionFields_CompactMatrix_h

#include "CompactValues.h"

#include <vector>

namespace DirectionFields
{
/// Hermitian matrix in single precision with the sweeps of a smoother. Compressed rows, columns
/// ascending; the diagonal stands apart.
///
/// Sweeps are Gauss-Seidel within blocks of BlockRows rows and Jacobi between them, so that blocks
/// run at once and results do not depend on the number of threads. What couples a row with other
/// blocks is added to its diagonal, which keeps the sweep convergent (the l1 smoother of
/// A. Baker et al., SIAM J. Sci. Comput. 33, 2011).
struct CompactMatrix
{
  static constexpr Index BlockRows = 4096;
  /// Rows of a piece where rows do not depend on each other.
  static constexpr Index PieceRows = 2048;

  /// Entries of row v: Begin[v] to Upper[v] left of the diagonal, Upper[v] to Begin[v + 1] right of it.
  std::vector<Index> Begin;
  std::vector<Index> Upper;
  std::vector<Index> Column;
  std::vector<CompactComplex> Value;
  std::vector<float> Diagonal;

  CompactMatrix() = default;
  /// Rounds a Hermitian matrix.
  explicit CompactMatrix(const SparseMatrix& matrix);

  Index Rows() const { return static_cast<Index>(this->Diagonal.size()); }

  /// Adds entries begin ... end - 1 of a row times x.
  template <int B>
  void AddTimes(Index begin, Index end, const float* x, CompactValues<B>& sum) const
  {
    AddProducts<B>(this->Value.data(), this->Column.data(), begin, end, x, sum);
  }

  /// Row v of A x.
  template <int B>
  CompactValues<B> RowTimes(Index v, const float* x) const
  {
    CompactValues<B> sum;
    sum.AddReal(this->Diagonal[v], x, v);
    AddManyProducts<B>(this->Value.data(), this->Column.data(), this->Begin[v],
      this->Begin[v + 1], x, sum);
    return sum;
  }
};

/// What a sweep divides by.
struct SweepDiagonal
{
  SweepDiagonal() = default;
  /// @param m, shift the matrix swept is A + shift m
  SweepDiagonal(const CompactMatrix& matrix, const std::vector<float>& m, float shift);

  /// Of A + shift m with the couplings to other blocks.
  std::vector<float> Inverse;
  /// The couplings to other blocks.
  std::vector<float> Extra;
};

/// One sweep downwards that starts from zero: x; and what it leaves of b: r = b - (A + shift m) x.
/// @param x, r B sections each
template <int B>
void SweepDown(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  float* x, float* r);

/// One sweep upwards that goes on from x: y.
template <int B>
void SweepUp(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* x, float* y);
}

#endif
