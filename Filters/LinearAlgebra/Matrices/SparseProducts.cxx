// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/SparseProducts.h"

#include "Matrices/RowSum.h"

namespace DirectionFields::Internal
{
namespace
{
constexpr Index ColumnPiece = 256;

/// One matrix of matrices side by side.
SparseMatrix SideBySide(Index rows, Index columns, const std::vector<SparseMatrix>& pieces)
{
  Eigen::Index entries = 0;
  for (const SparseMatrix& piece : pieces)
  {
    entries += piece.nonZeros();
  }
  SparseMatrix whole(rows, columns);
  whole.reserve(entries);
  Index column = 0;
  for (const SparseMatrix& piece : pieces)
  {
    for (Index k = 0; k < piece.cols(); ++k)
    {
      whole.startVec(column);
      for (SparseMatrix::InnerIterator it(piece, k); it; ++it)
      {
        whole.insertBack(it.row(), column) = it.value();
      }
      ++column;
    }
  }
  whole.finalize();
  return whole;
}

/// a times the columns of b from begin to end - 1. Eigen's product would pass over all rows of a
/// for each few columns of b.
SparseMatrix ProductOfColumns(const SparseMatrix& a, const SparseMatrix& b, Index begin, Index end)
{
  RowSum<Complex> sum;
  SparseMatrix product(a.rows(), end - begin);
  for (Index column = begin; column < end; ++column)
  {
    for (SparseMatrix::InnerIterator outer(b, column); outer; ++outer)
    {
      for (SparseMatrix::InnerIterator it(a, outer.row()); it; ++it)
      {
        sum[it.row()] += it.value() * outer.value();
      }
    }
    product.startVec(column - begin);
    sum.TakeSorted(
      [&](auto first, auto last)
      {
        for (; first != last; ++first)
        {
          product.insertBack(first->first, column - begin) = first->second;
        }
      });
  }
  product.finalize();
  return product;
}
}

SparseMatrix SelectedColumns(const SparseMatrix& matrix, const std::vector<Index>& chosen)
{
  return SelectedColumns(matrix, chosen, static_cast<Index>(matrix.rows()),
    [](Eigen::Index row) { return static_cast<Index>(row); });
}

SparseMatrix SparseProduct(const SparseMatrix& a, const SparseMatrix& b)
{
  const auto columns = static_cast<Index>(b.cols());
  std::vector<SparseMatrix> pieces(NumberOfPieces(columns, ColumnPiece));
  ParallelFor(columns, ColumnPiece,
    [&](Index begin, Index end)
    { pieces[begin / ColumnPiece] = ProductOfColumns(a, b, begin, end); });
  return SideBySide(static_cast<Index>(a.rows()), columns, pieces);
}

bool IsNormalMatrixSparse(const SparseMatrix& adjoint, double mostCouplings)
{
  double couplings = 0.0;
  for (Eigen::Index row = 0; row < adjoint.outerSize(); ++row)
  {
    const double unknowns = adjoint.outerIndexPtr()[row + 1] - adjoint.outerIndexPtr()[row];
    couplings += unknowns * unknowns;
  }
  return couplings <= mostCouplings * static_cast<double>(adjoint.nonZeros());
}
}
