// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SupernodalStructure.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Supernodes are joined with the one that they lead to where the zeros that are stored then are at
/// most this part of all, for up to this many columns: few wide blocks take less time than many
/// narrow ones.
struct Relaxation
{
  Index Columns;
  double Zeros;
};
constexpr Relaxation Relaxations[] = { { 4, 1.0 }, { 16, 0.8 }, { 48, 0.1 }, { 1 << 30, 0.05 } };
/// Branches of the tree that have less than this part of all the work go to one thread each.
constexpr double LargestBranch = 1.0 / 16.0;

/// An order of elimination that leaves little fill among the first rows, by approximate minimum
/// degree; the others stay behind it.
std::vector<std::int32_t> MinimumDegree(const LowerPattern& pattern, Index first)
{
  std::vector<std::int32_t> order(pattern.GetSize());
  std::iota(order.begin(), order.end(), 0);
  if (first == 0)
  {
    return order;
  }
  // The values do not matter.
  Eigen::SparseMatrix<char, Eigen::ColMajor, std::int32_t> block(first, first);
  std::vector<std::int32_t> rows;
  Index next = 0;
  pattern.ForEntries(
    [&](Index row, Index column)
    {
      for (; next <= std::min(column, first); ++next)
      {
        block.outerIndexPtr()[next] = static_cast<std::int32_t>(rows.size());
      }
      if (row < first)
      {
        rows.push_back(row);
      }
    });
  for (; next <= first; ++next)
  {
    block.outerIndexPtr()[next] = static_cast<std::int32_t>(rows.size());
  }
  block.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(rows.begin(), rows.end(), block.innerIndexPtr());
  std::fill_n(block.valuePtr(), rows.size(), char(0));
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> least;
  Eigen::AMDOrdering<std::int32_t>()(block.selfadjointView<Eigen::Lower>(), least);
  std::copy_n(least.indices().data(), first, order.begin());
  return order;
}
}

/// Columns that may become a supernode.
struct SupernodalStructure::Candidate
{
  Index First;
  Index End;
  Index Below;
  double Zeros;
  double Entries() const
  {
    const double width = this->End - this->First;
    return width * (0.5 * (width + 1.0) + this->Below);
  }
};

SupernodalStructure::SupernodalStructure(const LowerPattern& pattern, Index last)
  : Order(MinimumDegree(pattern, pattern.GetSize() - last))
  , Place(this->Order.size())
  , Last(last)
{
  for (std::size_t k = 0; k < this->Order.size(); ++k)
  {
    this->Place[this->Order[k]] = static_cast<Index>(k);
  }
  this->Reorder(EliminationTree(this->RowsOf(pattern)));
  const Lists rows = this->RowsOf(pattern);
  this->FindSupernodes(rows, EliminationTree(rows));
  this->FindRows(rows);
  this->FindBranches();
}

/// The places before each place in the order that it is coupled with.
SupernodalStructure::Lists SupernodalStructure::RowsOf(const LowerPattern& pattern) const
{
  const Index size = pattern.GetSize();
  Lists rows;
  rows.Ends.assign(size, 0);
  const auto forEntries = [&](const auto& visit)
  {
    pattern.ForEntries(
      [&](Index row, Index column)
      {
        const Index i = this->Place[row];
        const Index j = this->Place[column];
        if (i != j)
        {
          visit(std::max(i, j), std::min(i, j));
        }
      });
    // The last ones are dense: each of them is coupled with the next.
    for (Index i = size - this->Last + 1; i < size; ++i)
    {
      visit(i, i - 1);
    }
  };
  forEntries([&](Index row, Index) { ++rows.Ends[row]; });
  std::size_t sum = 0;
  for (std::size_t& end : rows.Ends)
  {
    sum += std::exchange(end, sum);
  }
  rows.Members.resize(sum);
  forEntries([&](Index row, Index column) { rows.Members[rows.Ends[row]++] = column; });
  return rows;
}

/// The first row of L below the diagonal of each column (J. Liu: The Role of Elimination Trees in
/// Sparse Factorization, 1990).
std::vector<Index> SupernodalStructure::EliminationTree(const Lists& rows)
{
  const auto size = static_cast<Index>(rows.Ends.size());
  std::vector<Index> parent(size, None);
  std::vector<Index> ancestor(size, None);
  for (Index i = 0; i < size; ++i)
  {
    for (const Index* j = rows.begin(i); j != rows.end(i); ++j)
    {
      Index k = *j;
      while (k != i && k != None)
      {
        const Index next = std::exchange(ancestor[k], i);
        if (next == None)
        {
          parent[k] = i;
        }
        k = next;
      }
    }
  }
  return parent;
}

/// Puts every node of the tree behind all that lead to it, and these next to each other. The last
/// one that leads to a node comes last, so that those that are to be last remain so.
void SupernodalStructure::Reorder(const std::vector<Index>& parent)
{
  const auto size = static_cast<Index>(parent.size());
  std::vector<Index> firstChild(size + 1, None);
  std::vector<Index> nextChild(size, None);
  for (Index k = size - 1; k >= 0; --k)
  {
    Index& first = firstChild[parent[k] == None ? size : parent[k]];
    nextChild[k] = first;
    first = k;
  }
  std::vector<std::int32_t> order;
  order.reserve(size);
  std::vector<Index> path = { size };
  while (!path.empty())
  {
    const Index k = path.back();
    const Index child = firstChild[k];
    if (child != None)
    {
      firstChild[k] = nextChild[child];
      path.push_back(child);
      continue;
    }
    path.pop_back();
    if (k < size)
    {
      order.push_back(this->Order[k]);
    }
  }
  this->Order = std::move(order);
  for (Index k = 0; k < size; ++k)
  {
    this->Place[this->Order[k]] = k;
  }
}

/// How many rows each column of L has below its diagonal.
std::vector<Index> SupernodalStructure::RowsBelow(
  const Lists& rows, const std::vector<Index>& parent)
{
  const auto size = static_cast<Index>(parent.size());
  std::vector<Index> below(size, 0);
  std::vector<Index> mark(size, None);
  for (Index i = 0; i < size; ++i)
  {
    mark[i] = i;
    for (const Index* j = rows.begin(i); j != rows.end(i); ++j)
    {
      for (Index k = *j; mark[k] != i; k = parent[k])
      {
        ++below[k];
        mark[k] = i;
      }
    }
  }
  return below;
}

/// Columns with the same rows, joined with those that they lead to where that stores few zeros.
std::vector<SupernodalStructure::Candidate> SupernodalStructure::FindColumns(
  const std::vector<Index>& below, const std::vector<Index>& parent) const
{
  const auto size = static_cast<Index>(parent.size());
  const Index reals = size - this->Last;
  std::vector<Candidate> found;
  for (Index k = 0; k < size;)
  {
    Candidate next{ k, k + 1, 0, 0.0 };
    while (next.End < size &&
      (k >= reals ||
        (next.End < reals && parent[next.End - 1] == next.End &&
          below[next.End - 1] == below[next.End] + 1)))
    {
      ++next.End;
    }
    next.Below = k >= reals ? 0 : below[next.End - 1];
    k = next.End;
    while (!found.empty() && next.First < reals && parent[found.back().End - 1] != None &&
      parent[found.back().End - 1] < next.End)
    {
      const Candidate& before = found.back();
      Candidate joined{ before.First, next.End, next.Below, 0.0 };
      joined.Zeros =
        before.Zeros + next.Zeros + joined.Entries() - before.Entries() - next.Entries();
      const Relaxation* limit = std::begin(Relaxations);
      while (joined.End - joined.First > limit->Columns)
      {
        ++limit;
      }
      if (joined.Zeros > limit->Zeros * joined.Entries())
      {
        break;
      }
      found.pop_back();
      next = joined;
    }
    found.push_back(next);
  }
  return found;
}

void SupernodalStructure::FindSupernodes(const Lists& rows, const std::vector<Index>& parent)
{
  const std::vector<Candidate> found = this->FindColumns(RowsBelow(rows, parent), parent);
  std::vector<Index> nodeOf(parent.size());
  this->Nodes.resize(found.size());
  for (std::size_t s = 0; s < found.size(); ++s)
  {
    this->Nodes[s].First = found[s].First;
    this->Nodes[s].End = found[s].End;
    std::fill(
      nodeOf.begin() + found[s].First, nodeOf.begin() + found[s].End, static_cast<Index>(s));
  }
  for (std::size_t s = 0; s < found.size(); ++s)
  {
    const Index next = parent[found[s].End - 1];
    if (next != None)
    {
      this->Nodes[s].Parent = nodeOf[next];
      this->Nodes[nodeOf[next]].Children.push_back(static_cast<Index>(s));
    }
  }
}

/// The rows below each supernode, and where its values are.
void SupernodalStructure::FindRows(const Lists& rows)
{
  const auto size = static_cast<Index>(rows.Ends.size());
  std::vector<Index> nodeOf(size);
  for (std::size_t s = 0; s < this->Nodes.size(); ++s)
  {
    std::fill(nodeOf.begin() + this->Nodes[s].First, nodeOf.begin() + this->Nodes[s].End,
      static_cast<Index>(s));
  }
  for (Index i = 0; i < size; ++i)
  {
    for (const Index* j = rows.begin(i); j != rows.end(i); ++j)
    {
      if (nodeOf[*j] != nodeOf[i])
      {
        this->Nodes[nodeOf[*j]].Rows.push_back(i);
      }
    }
  }
  std::size_t values = 0;
  for (Supernode& node : this->Nodes)
  {
    for (const Index child : node.Children)
    {
      const std::vector<Index>& lower = this->Nodes[child].Rows;
      node.Rows.insert(
        node.Rows.end(), std::lower_bound(lower.begin(), lower.end(), node.End), lower.end());
    }
    std::sort(node.Rows.begin(), node.Rows.end());
    node.Rows.erase(std::unique(node.Rows.begin(), node.Rows.end()), node.Rows.end());
    node.Rows.shrink_to_fit();
    node.Values = values;
    values += static_cast<std::size_t>(node.Height()) * node.Width();
  }
}

void SupernodalStructure::FindBranches()
{
  const auto count = static_cast<Index>(this->Nodes.size());
  std::vector<double> work(count, 0.0);
  std::vector<Index> firstOf(count);
  double all = 0.0;
  for (Index s = 0; s < count; ++s)
  {
    const Supernode& node = this->Nodes[s];
    all += node.GetWork();
    work[s] += node.GetWork();
    firstOf[s] = node.Children.empty() ? s : firstOf[node.Children.front()];
    if (node.Parent != None)
    {
      work[node.Parent] += work[s];
    }
  }
  for (Index s = count - 1; s >= 0;)
  {
    if (work[s] <= LargestBranch * all)
    {
      this->Branches.push_back({ firstOf[s], s });
      s = firstOf[s] - 1;
    }
    else
    {
      this->Trunk.push_back(s--);
    }
  }
  std::reverse(this->Trunk.begin(), this->Trunk.end());
}

Index SupernodalStructure::GetMostRows() const
{
  std::size_t most = 0;
  for (const Supernode& node : this->Nodes)
  {
    most = std::max(most, node.Rows.size());
  }
  return static_cast<Index>(most);
}

std::size_t SupernodalStructure::GetNumberOfValues() const
{
  if (this->Nodes.empty())
  {
    return 0;
  }
  const Supernode& last = this->Nodes.back();
  return last.Values + static_cast<std::size_t>(last.Height()) * last.Width();
}
}
