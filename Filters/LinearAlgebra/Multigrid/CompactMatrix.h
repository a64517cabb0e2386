// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompactMatrix_h
#define DirectionFields_CompactMatrix_h

#include "Matrices/CompactValues.h"

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// Hermitian matrix in single precision, as sweeps go through it. Compressed rows; the diagonal
/// stands apart.
struct CompactMatrix
{
  /// The number of rows of a block; a block is swept by itself.
  static constexpr Index BlockRows = 4096;
  /// The number of rows of a piece, where rows do not depend on each other.
  static constexpr Index PieceRows = 2048;

  /// The entries of row v in columns of its block are those from Begin[v] to Inside[v], and its
  /// entries in other columns those from Inside[v] to Begin[v + 1].
  LargeArray<Index> Begin;
  LargeArray<Index> Inside;
  LargeArray<Index> Column;
  /// The column counted from the first row of the block; 0 for columns of other blocks.
  LargeArray<std::uint16_t> ColumnInBlock;
  LargeArray<CompactComplex> Value;
  LargeArray<float> Diagonal;
  /// The rows with entries in columns of other blocks, ascending.
  LargeArray<Index> Boundary;
  /// A copy of those entries: row j of the boundary has those from OutsideBegin[j] to
  /// OutsideBegin[j + 1]. Their columns belong to the boundary, too, and are counted in it.
  LargeArray<Index> OutsideBegin;
  LargeArray<Index> OutsideColumn;
  LargeArray<CompactComplex> OutsideValue;
  /// A row that is swept more often.
  struct LocalRow
  {
    Index Row;
    /// The row counted in the boundary, or None.
    Index Boundary;
  };
  /// Rows whose couplings add up to much more than the diagonal, as at slivers, and the rows that
  /// they are coupled with, ascending: coarser levels correct them badly. Empty before
  /// FindLocalRows.
  std::vector<LocalRow> Local;

  CompactMatrix() = default;
  /// Rounds a Hermitian matrix.
  explicit CompactMatrix(const SparseMatrix& matrix);

  /// Brings the entries of rows with ascending columns in order, and fills in Inside and Boundary.
  /// @param other has the same pattern, and gets the same order
  void OrderByBlocks(LargeArray<CompactComplex>* other = nullptr);
  /// Fills in the parts that only sweeps need: ColumnInBlock and the couplings of the boundary.
  void PrepareSweeps();
  /// Fills in Local. Where many rows are like that, only the worst ones are taken: more of them
  /// would take longer than they save.
  void FindLocalRows();

  Index Rows() const { return static_cast<Index>(this->Diagonal.size()); }
  /// The number of entries outside the diagonal.
  Index Entries() const { return this->Begin.back(); }
  /// The first row of the boundary, counted in it, from a row on.
  Index BoundaryFrom(Index row) const;

  /// Row v of A x for B sections x.
  template <int B>
  CompactValues<B> RowTimes(Index v, const float* x) const
  {
    CompactValues<B> sum;
    sum.AddReal(this->Diagonal[v], x, v);
    AddManyProducts(
      this->Value.data(), this->Column.data(), this->Begin[v], this->Begin[v + 1], x, sum);
    return sum;
  }
};
}

#endif
