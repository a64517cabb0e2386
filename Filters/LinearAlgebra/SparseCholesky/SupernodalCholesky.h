// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SupernodalCholesky_h
#define DirectionFields_SupernodalCholesky_h

#include "Progress.h"
#include "SparseCholesky/SupernodalStructure.h"
#include "Support/LargeArray.h"
#include "Types.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// The factorization P K P^T = L L^* of a sparse Hermitian matrix. Columns of L that have nearly
/// the same rows are one dense block, a supernode, and so is the update that each leaves to those
/// behind it (J. Liu: The Multifrontal Method for Sparse Matrix Solution, 1992). Branches of the
/// elimination tree are factored on all threads, and the large blocks in pieces; the factor has the
/// same bytes for any number of threads.
/// @tparam Scalar double or std::complex<double>
template <typename Scalar>
class SupernodalCholesky
{
public:
  /// Only the lower triangle of a matrix is looked at.
  using Matrix = Eigen::SparseMatrix<Scalar, Eigen::ColMajor, std::int32_t>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// Returns whether the matrix is positive definite up to rounding. The rows are eliminated in an
  /// order that leaves little fill. Meanwhile progress is asked, by the calling thread, whether to
  /// go on; throws Stopped.
  bool Compute(const Matrix& matrix, const Progress& progress = {});
  /// The same, with the last rows eliminated behind all others, in their own order, as one dense
  /// block.
  /// @param last the number of these rows
  bool Compute(const Matrix& matrix, Index last, const Progress& progress = {});
  std::size_t GetNumberOfValues() const { return this->Structure.GetNumberOfValues(); }
  /// Nothing can be solved until the matrix is factored again.
  void ReleaseValues() { LargeArray<Scalar>().swap(this->Values); }
  /// With the order and the blocks found before.
  /// @param matrix the same as for Compute
  void FactorAgain(const Matrix& matrix) { this->Factor(matrix, {}); }
  Vector Solve(const Vector& rightHandSide) const;
  /// The change of the solution where its last rows change by a given vector and the right-hand
  /// side of the others stays.
  Vector Continued(const Vector& last) const;
  /// The lower factor of the Schur complement of the last rows.
  Dense TrailingFactor() const;

private:
  class Elimination;

  bool Factor(const Matrix& matrix, const Progress& progress);
  /// The lower triangle of P K P^T.
  Matrix Permuted(const Matrix& matrix) const;
  /// P^T x
  Vector PermutedBack(const Vector& x) const;
  /// Solves the rows of the first nodes of L^* y = x for y, in place of x. The other rows of x are
  /// those of y already.
  void SubstituteBackward(Vector& x, std::size_t nodes) const;
  Eigen::Map<const Dense> Block(const Supernode& node) const
  {
    return { this->Values.data() + node.Values, node.Height(), node.Width() };
  }

  SupernodalStructure Structure;
  Index Last = 0;
  LargeArray<Scalar> Values;
};

/// Of energies, masses and their combinations. Of such matrices, whose entries are given on both
/// sides of the diagonal, half is not looked at.
using ComplexCholesky = SupernodalCholesky<Complex>;

extern template class SupernodalCholesky<double>;
extern template class SupernodalCholesky<std::complex<double>>;
}

#endif
