// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SupernodalCholesky_h
#define DirectionFields_SupernodalCholesky_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// The factorization P K P^T = L L^T of a sparse symmetric matrix. Columns of L that have nearly the same rows are one
/// dense block, a supernode, and what each leaves to those behind it is one dense matrix, too (J. Liu: The
/// Multifrontal Method for Sparse Matrix Solution, 1992). Branches of the elimination tree are factored on all
/// threads, and the large blocks in pieces; the factor has the same bytes for any number of them.
class SupernodalCholesky
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t>;

  /// Returns whether the matrix is positive definite up to rounding.
  /// @param lower its lower triangle
  /// @param order the rows in the order in which they are to be eliminated, as far as it matters for the fill
  /// @param last  that many of these, the last ones, are eliminated in exactly this order, as one dense block
  bool Compute(const Matrix& lower, std::vector<std::int32_t> order, Index last);
  std::size_t GetNumberOfValues() const;
  /// Nothing can be solved until the matrix is factored again.
  void ReleaseValues() { LargeArray<double>().swap(this->Values); }
  /// With the order and the blocks found before.
  /// @param lower the same as for Compute
  void FactorAgain(const Matrix& lower) { this->FactorAll(lower); }
  Eigen::VectorXd Solve(const Eigen::VectorXd& rightHandSide) const;
  /// How the solution changes where its last rows change by as much as is given and the right-hand side of the others
  /// stays.
  Eigen::VectorXd Continued(const Eigen::VectorXd& last) const;
  /// The lower factor of the Schur complement of the last rows.
  Eigen::MatrixXd TrailingFactor() const;

private:
  /// Lists of numbers, one after the other.
  struct Lists
  {
    LargeArray<Index> Members;
    std::vector<std::size_t> Ends;
    const Index* begin(Index k) const
    {
      return this->Members.data() + (k > 0 ? this->Ends[k - 1] : 0);
    }
    const Index* end(Index k) const { return this->Members.data() + this->Ends[k]; }
  };
  /// Columns of L, and the rows below them.
  struct Supernode
  {
    Index First;
    Index End;
    Index Parent = None;
    std::vector<Index> Rows;
    std::vector<Index> Children;
    /// Where its block is among the values: its columns one after the other, from their diagonal block on.
    std::size_t Values = 0;
    Index Width() const { return this->End - this->First; }
    Index Height() const { return this->Width() + static_cast<Index>(this->Rows.size()); }
  };

  /// Solves the rows of the first nodes of L^T y = x for y in place of x, whose other rows are those of y.
  void SubstituteBackward(Eigen::VectorXd& x, std::size_t nodes) const;
  /// From the order of elimination to that of the matrix.
  Eigen::VectorXd InOrder(const Eigen::VectorXd& x) const;
  Lists RowsOf(const Matrix& lower) const;
  std::vector<Index> EliminationTree(const Lists& rows) const;
  void Reorder(const std::vector<Index>& parent);
  void FindSupernodes(const Lists& rows, const std::vector<Index>& parent);
  void FindStructure(const Lists& rows);
  void FactorAll(const Matrix& lower);
  bool Factor(Index s, const Matrix& values, std::vector<Eigen::MatrixXd>& updates);
  void Gather(Index s, const Matrix& values, std::vector<Eigen::MatrixXd>& updates);
  Eigen::Map<Eigen::MatrixXd> Block(const Supernode& node)
  {
    return { this->Values.data() + node.Values, node.Height(), node.Width() };
  }
  Eigen::Map<const Eigen::MatrixXd> Block(const Supernode& node) const
  {
    return { this->Values.data() + node.Values, node.Height(), node.Width() };
  }

  std::vector<std::int32_t> Order;
  std::vector<Index> Place;
  Index Last = 0;
  std::vector<Supernode> Nodes;
  LargeArray<double> Values;
  bool IsDefinite = false;
};
}

#endif
