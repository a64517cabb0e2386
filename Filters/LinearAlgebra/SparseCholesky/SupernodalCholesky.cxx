// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SupernodalCholesky.h"

#include "Support/Threads.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <numeric>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Supernodes are joined with the one that they lead to where the zeros that are stored then are at most such a part of
/// all, for up to so many columns: few wide blocks take less time than many narrow ones.
struct Relaxation
{
  Index Columns;
  double Zeros;
};
constexpr Relaxation Relaxations[] = { { 4, 1.0 }, { 16, 0.8 }, { 48, 0.1 }, { 1 << 30, 0.05 } };
/// Rows and columns of pieces of large blocks.
constexpr Index PieceSize = 96;
/// Branches of the tree that have less than this part of all the work go to one thread each.
constexpr double LargestBranch = 1.0 / 16.0;
}

/// The places before each place in the order that it is coupled with.
SupernodalCholesky::Lists SupernodalCholesky::RowsOf(const Matrix& lower) const
{
  const auto size = static_cast<Index>(lower.cols());
  Lists rows;
  rows.Ends.assign(size, 0);
  const auto forEntries = [&](const auto& visit)
  {
    for (Index column = 0; column < size; ++column)
    {
      for (Matrix::InnerIterator entry(lower, column); entry; ++entry)
      {
        const Index i = this->Place[entry.row()];
        const Index j = this->Place[column];
        if (i != j)
        {
          visit(std::max(i, j), std::min(i, j));
        }
      }
    }
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

/// The first row of L below the diagonal of each column (J. Liu: The Role of Elimination Trees in Sparse
/// Factorization, 1990).
std::vector<Index> SupernodalCholesky::EliminationTree(const Lists& rows) const
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

/// Puts every node of the tree behind all that lead to it, and these next to each other. The last one that leads to a
/// node comes last, so that those that are to be last remain so.
void SupernodalCholesky::Reorder(const std::vector<Index>& parent)
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

void SupernodalCholesky::FindSupernodes(const Lists& rows, const std::vector<Index>& parent)
{
  const auto size = static_cast<Index>(parent.size());
  const Index reals = size - this->Last;
  // The rows below the diagonal of each column of L.
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
  struct Candidate
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
  std::vector<Index> nodeOf(size);
  this->Nodes.clear();
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
void SupernodalCholesky::FindStructure(const Lists& rows)
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

std::size_t SupernodalCholesky::GetNumberOfValues() const
{
  return this->Nodes.empty() ? 0
                             : this->Nodes.back().Values +
      static_cast<std::size_t>(this->Nodes.back().Height()) * this->Nodes.back().Width();
}

bool SupernodalCholesky::Compute(const Matrix& lower, std::vector<std::int32_t> order, Index last)
{
  this->Order = std::move(order);
  this->Last = last;
  this->Place.resize(this->Order.size());
  for (std::size_t k = 0; k < this->Order.size(); ++k)
  {
    this->Place[this->Order[k]] = static_cast<Index>(k);
  }
  this->Reorder(this->EliminationTree(this->RowsOf(lower)));
  {
    const Lists rows = this->RowsOf(lower);
    this->FindSupernodes(rows, this->EliminationTree(rows));
    this->FindStructure(rows);
  }
  this->FactorAll(lower);
  return this->IsDefinite;
}

void SupernodalCholesky::FactorAll(const Matrix& lower)
{
  // The entries by the columns of L that they are in.
  Matrix values(lower.rows(), lower.cols());
  {
    std::vector<std::int32_t> counts(lower.cols(), 0);
    const auto forEntries = [&](const auto& visit)
    {
      for (Eigen::Index column = 0; column < lower.cols(); ++column)
      {
        for (Matrix::InnerIterator entry(lower, column); entry; ++entry)
        {
          const Index i = this->Place[entry.row()];
          const Index j = this->Place[column];
          visit(std::max(i, j), std::min(i, j), entry.value());
        }
      }
    };
    forEntries([&](Index, Index j, double) { ++counts[j]; });
    values.resizeNonZeros(lower.nonZeros());
    std::int32_t sum = 0;
    for (Eigen::Index column = 0; column < lower.cols(); ++column)
    {
      values.outerIndexPtr()[column] = sum;
      sum += std::exchange(counts[column], sum);
    }
    values.outerIndexPtr()[lower.cols()] = sum;
    forEntries(
      [&](Index i, Index j, double value)
      {
        values.innerIndexPtr()[counts[j]] = i;
        values.valuePtr()[counts[j]++] = value;
      });
  }
  this->Values.resize(this->GetNumberOfValues());
  const auto count = static_cast<Index>(this->Nodes.size());
  std::vector<double> work(count, 0.0);
  std::vector<Index> firstOf(count);
  double all = 0.0;
  for (Index s = 0; s < count; ++s)
  {
    const Supernode& node = this->Nodes[s];
    const double own = static_cast<double>(node.Width()) * node.Height() * node.Height();
    all += own;
    work[s] += own;
    firstOf[s] = node.Children.empty() ? s : firstOf[node.Children.front()];
    if (node.Parent != None)
    {
      work[node.Parent] += work[s];
    }
  }
  std::vector<Index> branches;
  std::vector<Index> trunk;
  for (Index s = count - 1; s >= 0;)
  {
    const bool isBranch = work[s] <= LargestBranch * all;
    (isBranch ? branches : trunk).push_back(s);
    s = isBranch ? firstOf[s] - 1 : s - 1;
  }
  std::vector<Eigen::MatrixXd> updates(count);
  std::vector<char> isDefinite(branches.size(), 1);
  Threads::Run(static_cast<Index>(branches.size()),
    [&](Index k)
    {
      for (Index s = firstOf[branches[k]]; s <= branches[k] && isDefinite[k] != 0; ++s)
      {
        isDefinite[k] = this->Factor(s, values, updates) ? 1 : 0;
      }
    });
  this->IsDefinite =
    std::all_of(isDefinite.begin(), isDefinite.end(), [](char is) { return is != 0; });
  for (auto s = trunk.rbegin(); s != trunk.rend() && this->IsDefinite; ++s)
  {
    this->IsDefinite = this->Factor(*s, values, updates);
  }
}

/// Adds up what the matrix and the supernodes that lead to one have for it.
void SupernodalCholesky::Gather(
  Index s, const Matrix& values, std::vector<Eigen::MatrixXd>& updates)
{
  const Supernode& node = this->Nodes[s];
  Eigen::Map<Eigen::MatrixXd> block = this->Block(node);
  block.setZero();
  updates[s].setZero(static_cast<Index>(node.Rows.size()), static_cast<Index>(node.Rows.size()));
  for (Index column = node.First; column < node.End; ++column)
  {
    for (Matrix::InnerIterator entry(values, column); entry; ++entry)
    {
      const Index row = entry.row();
      const Index at = row < node.End ? row - node.First
                                      : node.Width() +
          static_cast<Index>(
            std::lower_bound(node.Rows.begin(), node.Rows.end(), row) - node.Rows.begin());
      block(at, column - node.First) += entry.value();
    }
  }
  std::vector<Index> place;
  for (const Index child : node.Children)
  {
    const std::vector<Index>& rows = this->Nodes[child].Rows;
    place.clear();
    auto at = node.Rows.begin();
    for (const Index row : rows)
    {
      if (row >= node.End)
      {
        at = std::lower_bound(at, node.Rows.end(), row);
      }
      place.push_back(row < node.End ? row - node.First
                                     : node.Width() + static_cast<Index>(at - node.Rows.begin()));
    }
    const Eigen::MatrixXd& update = updates[child];
    const Index below = node.Height() - node.Width();
    for (std::size_t j = 0; j < place.size(); ++j)
    {
      const bool isOwn = place[j] < node.Width();
      double* const to = isOwn ? block.data() : updates[s].data();
      const std::ptrdiff_t column = isOwn
        ? static_cast<std::ptrdiff_t>(place[j]) * node.Height()
        : static_cast<std::ptrdiff_t>(place[j] - node.Width()) * below - node.Width();
      const double* const from = update.data() + j * place.size();
      for (std::size_t i = j; i < place.size(); ++i)
      {
        to[column + place[i]] += from[i];
      }
    }
    updates[child].resize(0, 0);
  }
}

bool SupernodalCholesky::Factor(
  Index s, const Matrix& values, std::vector<Eigen::MatrixXd>& updates)
{
  this->Gather(s, values, updates);
  const Supernode& node = this->Nodes[s];
  const Index width = node.Width();
  const Index below = node.Height() - width;
  Eigen::Map<Eigen::MatrixXd> block = this->Block(node);
  Eigen::Ref<Eigen::MatrixXd> top = block.topRows(width);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(top);
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  ParallelFor(below, PieceSize,
    [&](Index begin, Index end)
    {
      top.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(
        block.middleRows(width + begin, end - begin));
    });
  const auto rest = block.bottomRows(below);
  ParallelFor(below, PieceSize,
    [&](Index begin, Index end)
    {
      const Index size = end - begin;
      updates[s]
        .block(begin, begin, size, size)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(rest.middleRows(begin, size), -1.0);
      updates[s].block(end, begin, below - end, size).noalias() -=
        rest.bottomRows(below - end) * rest.middleRows(begin, size).transpose();
    });
  return true;
}
}
