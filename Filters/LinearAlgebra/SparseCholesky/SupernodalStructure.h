// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SupernodalStructure_h
#define DirectionFields_SupernodalStructure_h

#include "SparseCholesky/LowerPattern.h"
#include "Support/LargeArray.h"
#include "Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// Columns of the factor L, and the rows below them.
struct Supernode
{
  Index First;
  Index End;
  Index Parent = None;
  std::vector<Index> Rows;
  std::vector<Index> Children;
  /// Where its block begins among the values of L: column by column, the diagonal block on top.
  std::size_t Values = 0;
  Index Width() const { return this->End - this->First; }
  Index Height() const { return this->Width() + static_cast<Index>(this->Rows.size()); }
  /// About twice the multiplications that eliminating its columns takes.
  double GetWork() const
  {
    return static_cast<double>(this->Width()) * this->Height() * this->Height();
  }
};

/// The structure of the factor P K P^T = L L^*, from the pattern of a Hermitian matrix: an order of
/// elimination that leaves little fill, and the supernodes, columns of L that have nearly the same
/// rows, as the nodes of a tree.
class SupernodalStructure
{
public:
  SupernodalStructure() = default;
  /// @param last the number of rows at the end of the matrix that are eliminated last, in their own
  ///             order, as one supernode
  SupernodalStructure(const LowerPattern& pattern, Index last);

  /// The row of the matrix at each place, and the place of each row.
  const std::vector<std::int32_t>& GetOrder() const { return this->Order; }
  const std::vector<Index>& GetPlace() const { return this->Place; }
  /// Each behind all that lead to it.
  const std::vector<Supernode>& GetNodes() const { return this->Nodes; }
  /// Of all blocks together.
  std::size_t GetNumberOfValues() const;
  /// The most rows that a supernode has below its own.
  Index GetMostRows() const;

  /// Supernodes from First to Last, which is the root of their part of the tree.
  struct Branch
  {
    Index First;
    Index Last;
  };
  /// Parts of the tree of little work each, which do not depend on each other.
  const std::vector<Branch>& GetBranches() const { return this->Branches; }
  /// The supernodes that are left, each behind all that lead to it.
  const std::vector<Index>& GetTrunk() const { return this->Trunk; }

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
  struct Candidate;

  Lists RowsOf(const LowerPattern& pattern) const;
  static std::vector<Index> EliminationTree(const Lists& rows);
  void Reorder(const std::vector<Index>& parent);
  static std::vector<Index> RowsBelow(const Lists& rows, const std::vector<Index>& parent);
  std::vector<Candidate> FindColumns(
    const std::vector<Index>& below, const std::vector<Index>& parent) const;
  void FindSupernodes(const Lists& rows, const std::vector<Index>& parent);
  void FindRows(const Lists& rows);
  void FindBranches();

  std::vector<std::int32_t> Order;
  std::vector<Index> Place;
  Index Last = 0;
  std::vector<Supernode> Nodes;
  std::vector<Branch> Branches;
  std::vector<Index> Trunk;
};
}

#endif
