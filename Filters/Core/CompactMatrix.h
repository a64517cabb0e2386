// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompactMatrix_h
#define DirectionFields_CompactMatrix_h

#include "CompactValues.h"

#include <cstdint>
#include <vector>

namespace DirectionFields
{
/// Hermitian matrix in single precision with the sweeps of a smoother. Compressed rows; the diagonal
/// stands apart.
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

  /// Entries of row v: Begin[v] to Inside[v] in columns of its block, Inside[v] to Begin[v + 1] in
  /// others.
  LargeArray<Index> Begin;
  LargeArray<Index> Inside;
  LargeArray<Index> Column;
  /// The same counted from the first row of the block; 0 for columns of other blocks.
  LargeArray<std::uint16_t> ColumnInBlock;
  LargeArray<CompactComplex> Value;
  LargeArray<float> Diagonal;
  /// The rows with entries in columns of other blocks, ascending.
  LargeArray<Index> Boundary;
  /// Those entries of row j of the boundary again: OutsideBegin[j] to OutsideBegin[j + 1]. Their
  /// columns, which are of the boundary, too, are counted in it.
  LargeArray<Index> OutsideBegin;
  LargeArray<Index> OutsideColumn;
  LargeArray<CompactComplex> OutsideValue;

  CompactMatrix() = default;
  /// Rounds a Hermitian matrix.
  explicit CompactMatrix(const SparseMatrix& matrix);

  /// Brings the entries of rows with ascending columns in order, and fills in Inside and Boundary.
  /// @param other has the same pattern, and gets the same order
  void OrderByBlocks(LargeArray<CompactComplex>* other = nullptr);
  /// Fills in what only sweeps need: ColumnInBlock and the couplings of the boundary.
  void PrepareSweeps();

  Index Rows() const { return static_cast<Index>(this->Diagonal.size()); }
  /// But for the diagonal.
  Index Entries() const { return this->Begin.back(); }
  /// The first row of the boundary, counted in it, from a row on.
  Index BoundaryFrom(Index row) const;

  /// Row v of A x.
  template <int B>
  CompactValues<B> RowTimes(Index v, const float* x) const
  {
    CompactValues<B> sum;
    sum.AddReal(this->Diagonal[v], x, v);
    AddManyProducts(this->Value.data(), this->Column.data(), this->Begin[v], this->Begin[v + 1],
      x, sum);
    return sum;
  }
};

/// The matrix A + shift m that is swept, but for its entries.
struct SweepDiagonal
{
  SweepDiagonal() = default;
  /// @param m, shift   as above
  /// @param relaxation how far a sweep goes towards each row's solution, above 0 and below 2
  SweepDiagonal(const CompactMatrix& matrix, const LargeArray<float>& m, float shift,
    float relaxation = 1.0f);

  float Relaxation = 1.0f;
  LargeArray<float> Diagonal;
  /// The relaxation over the diagonal and the couplings to other blocks.
  LargeArray<float> Inverse;
  /// The couplings to other blocks of each row of the boundary.
  LargeArray<float> Extra;
};

/// In the order of the rows, or in the opposite one: sweeps adjoint to each other.
enum class SweepOrder
{
  Down,
  Up
};

/// One sweep for (A + shift m) x = b that goes on from x.
/// @param b, x    B sections each
/// @param r       b - (A + shift m) x once swept, in the same pass over the matrix; or null
/// @param product Re b^* x once swept, of all sections, likewise
template <int B>
void Sweep(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x, float* r = nullptr, double* product = nullptr);

/// One sweep down that starts from zero.
template <int B>
void SweepFromZero(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  float* x, float* r = nullptr);
}

#endif
