// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SupernodalCholesky.h"

#include "Support/Threads.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Rows and columns of pieces of large blocks.
constexpr Index PieceSize = 96;
/// From this number of columns on, products of complex blocks are made of real ones, which Eigen
/// multiplies faster: large matrices are factored in a fifth less time.
constexpr Index WideColumns = 16;
/// Between two questions whether to go on, in the unit of Supernode::GetWork: some hundredths of a
/// second.
constexpr double WorkBetweenQuestions = 5e7;

/// Whether to go on. The thread that has made the object asks progress; the others learn from it.
class Questions
{
public:
  explicit Questions(const Progress& progress)
    : Listener(progress)
    , Asker(std::this_thread::get_id())
  {
  }

  /// False where another thread has been told to stop; throws Stopped.
  /// @param work about twice the multiplications that come next
  bool MayGoOn(double work)
  {
    if (!this->Listener.Listens())
    {
      return true;
    }
    if (std::this_thread::get_id() == this->Asker)
    {
      this->Work += work;
      if (this->Work > WorkBetweenQuestions)
      {
        this->Work = 0.0;
        this->Ask();
      }
    }
    return !this->IsStopped;
  }

private:
  void Ask()
  {
    try
    {
      this->Listener.RequireToGoOn();
    }
    catch (...)
    {
      this->IsStopped = true;
      throw;
    }
  }

  const Progress& Listener;
  std::thread::id Asker;
  double Work = 0.0;
  std::atomic<bool> IsStopped{ false };
};
}

/// Subtracts B B^* from the lower triangle of an update. What is above of it may change, too.
template <typename Block, typename Scalar>
void SubtractSquare(
  const Block& block, Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& update)
{
  const auto below = static_cast<Index>(block.rows());
  if constexpr (Eigen::NumTraits<Scalar>::IsComplex)
  {
    if (block.cols() >= WideColumns)
    {
      // With B = X + i Y the parts of B B^* are (X Y) (X Y)^T and (Y -X) (X Y)^T.
      Eigen::MatrixXd left(below, 2 * block.cols());
      Eigen::MatrixXd right(below, 2 * block.cols());
      left << block.real(), block.imag();
      right << block.imag(), -block.real();
      ParallelFor(below, PieceSize,
        [&](Index begin, Index end)
        {
          const Index size = end - begin;
          const Index rows = below - begin;
          const auto columns = left.middleRows(begin, size).transpose();
          const Eigen::MatrixXd real = left.bottomRows(rows) * columns;
          const Eigen::MatrixXd imaginary = right.bottomRows(rows) * columns;
          auto piece = update.block(begin, begin, rows, size);
          piece.real() -= real;
          piece.imag() -= imaginary;
        });
      return;
    }
  }
  ParallelFor(below, PieceSize,
    [&](Index begin, Index end)
    {
      const Index size = end - begin;
      update.block(begin, begin, size, size)
        .template selfadjointView<Eigen::Lower>()
        .rankUpdate(block.middleRows(begin, size), -1.0);
      update.block(end, begin, below - end, size).noalias() -=
        block.bottomRows(below - end) * block.middleRows(begin, size).adjoint();
    });
}

/// One run over the tree, which leaves the values of the factor.
template <typename Scalar>
class SupernodalCholesky<Scalar>::Elimination
{
public:
  /// @param matrix in the order of elimination
  /// @param values of the factor
  Elimination(const SupernodalStructure& structure, Matrix matrix, Scalar* values)
    : Structure(structure)
    , Ordered(std::move(matrix))
    , Values(values)
    , Updates(structure.GetNodes().size())
  {
  }

  /// Returns whether the matrix is positive definite.
  bool Factor(const Progress& progress)
  {
    Questions questions(progress);
    const std::vector<SupernodalStructure::Branch>& branches = this->Structure.GetBranches();
    std::vector<char> isDefinite(branches.size(), 1);
    Threads::Run(static_cast<Index>(branches.size()),
      [&](Index k)
      {
        for (Index s = branches[k].First; s <= branches[k].Last && isDefinite[k] != 0; ++s)
        {
          isDefinite[k] = this->Eliminate(s, questions) ? 1 : 0;
        }
      });
    return std::all_of(isDefinite.begin(), isDefinite.end(), [](char is) { return is != 0; }) &&
      std::all_of(this->Structure.GetTrunk().begin(), this->Structure.GetTrunk().end(),
        [&](Index s) { return this->Eliminate(s, questions); });
  }

private:
  bool Eliminate(Index s, Questions& questions);
  void Gather(Index s);
  void GatherFrom(Index child, Index s);

  const SupernodalStructure& Structure;
  Matrix Ordered;
  Scalar* Values;
  /// The update that each supernode leaves to those behind it: a lower triangle over its rows.
  std::vector<Dense> Updates;
};

/// Adds up the entries of the matrix and the updates of the supernodes that lead to this one.
template <typename Scalar>
void SupernodalCholesky<Scalar>::Elimination::Gather(Index s)
{
  const Supernode& node = this->Structure.GetNodes()[s];
  Eigen::Map<Dense> block(this->Values + node.Values, node.Height(), node.Width());
  block.setZero();
  const auto below = static_cast<Index>(node.Rows.size());
  this->Updates[s].setZero(below, below);
  for (Index column = node.First; column < node.End; ++column)
  {
    for (typename Matrix::InnerIterator entry(this->Ordered, column); entry; ++entry)
    {
      const auto row = static_cast<Index>(entry.row());
      const Index at = row < node.End ? row - node.First
                                      : node.Width() +
          static_cast<Index>(
            std::lower_bound(node.Rows.begin(), node.Rows.end(), row) - node.Rows.begin());
      block(at, column - node.First) += entry.value();
    }
  }
  for (const Index child : node.Children)
  {
    this->GatherFrom(child, s);
  }
}

/// Adds the update of a supernode to the block and the update of the one that it leads to.
template <typename Scalar>
void SupernodalCholesky<Scalar>::Elimination::GatherFrom(Index child, Index s)
{
  const Supernode& node = this->Structure.GetNodes()[s];
  std::vector<Index> place;
  auto at = node.Rows.begin();
  for (const Index row : this->Structure.GetNodes()[child].Rows)
  {
    if (row >= node.End)
    {
      at = std::lower_bound(at, node.Rows.end(), row);
    }
    place.push_back(row < node.End ? row - node.First
                                   : node.Width() + static_cast<Index>(at - node.Rows.begin()));
  }
  const Index below = node.Height() - node.Width();
  for (std::size_t j = 0; j < place.size(); ++j)
  {
    const bool isOwn = place[j] < node.Width();
    Scalar* const to = isOwn ? this->Values + node.Values : this->Updates[s].data();
    const std::ptrdiff_t column = isOwn
      ? static_cast<std::ptrdiff_t>(place[j]) * node.Height()
      : static_cast<std::ptrdiff_t>(place[j] - node.Width()) * below - node.Width();
    const Scalar* const from = this->Updates[child].data() + j * place.size();
    for (std::size_t i = j; i < place.size(); ++i)
    {
      to[column + place[i]] += from[i];
    }
  }
  this->Updates[child].resize(0, 0);
}

/// Returns whether the rest of the matrix still is positive definite.
template <typename Scalar>
bool SupernodalCholesky<Scalar>::Elimination::Eliminate(Index s, Questions& questions)
{
  const Supernode& node = this->Structure.GetNodes()[s];
  if (!questions.MayGoOn(node.GetWork()))
  {
    return false;
  }
  this->Gather(s);
  const Index width = node.Width();
  const Index below = node.Height() - width;
  Eigen::Map<Dense> block(this->Values + node.Values, node.Height(), width);
  Eigen::Ref<Dense> top = block.topRows(width);
  // The class LLT would compute a norm of the block, too, which takes a twentieth of all time. It
  // takes what is not a number for positive.
  if (Eigen::internal::llt_inplace<Scalar, Eigen::Lower>::blocked(top) >= 0 ||
    !(top.diagonal().real().array() > 0.0).all())
  {
    return false;
  }
  ParallelFor(below, PieceSize,
    [&](Index begin, Index end)
    {
      top.adjoint()
        .template triangularView<Eigen::Upper>()
        .template solveInPlace<Eigen::OnTheRight>(block.middleRows(width + begin, end - begin));
    });
  SubtractSquare(block.bottomRows(below), this->Updates[s]);
  return true;
}

template <typename Scalar>
bool SupernodalCholesky<Scalar>::Compute(const Matrix& matrix, const Progress& progress)
{
  return this->Compute(matrix, 0, progress);
}

template <typename Scalar>
bool SupernodalCholesky<Scalar>::Compute(const Matrix& matrix, Index last, const Progress& progress)
{
  progress.RequireToGoOn();
  const LowerPattern pattern(matrix);
  this->Last = last;
  this->Structure = SupernodalStructure(pattern, last);
  progress.RequireToGoOn();
  return this->Factor(matrix, progress);
}

template <typename Scalar>
bool SupernodalCholesky<Scalar>::Factor(const Matrix& matrix, const Progress& progress)
{
  this->Values.resize(this->GetNumberOfValues());
  return Elimination(this->Structure, this->Permuted(matrix), this->Values.data()).Factor(progress);
}

template <typename Scalar>
typename SupernodalCholesky<Scalar>::Matrix SupernodalCholesky<Scalar>::Permuted(
  const Matrix& matrix) const
{
  const std::vector<Index>& place = this->Structure.GetPlace();
  const Eigen::Index size = matrix.cols();
  std::vector<std::int32_t> counts(size, 0);
  const LowerPattern pattern(matrix);
  pattern.ForEntries(
    [&](Index row, Index column) { ++counts[std::min(place[row], place[column])]; });
  Matrix ordered(size, size);
  std::int32_t sum = 0;
  for (Eigen::Index column = 0; column < size; ++column)
  {
    ordered.outerIndexPtr()[column] = sum;
    sum += std::exchange(counts[column], sum);
  }
  ordered.outerIndexPtr()[size] = sum;
  ordered.resizeNonZeros(sum);
  for (Index column = 0; column < size; ++column)
  {
    for (typename Matrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() < column)
      {
        continue;
      }
      const Index i = place[entry.row()];
      const Index j = place[column];
      const std::int32_t at = counts[std::min(i, j)]++;
      ordered.innerIndexPtr()[at] = std::max(i, j);
      ordered.valuePtr()[at] = i < j ? Eigen::numext::conj(entry.value()) : entry.value();
    }
  }
  return ordered;
}

template <typename Scalar>
typename SupernodalCholesky<Scalar>::Vector SupernodalCholesky<Scalar>::Solve(
  const Vector& rightHandSide) const
{
  const Eigen::Index size = rightHandSide.size();
  Vector x(size);
  for (Eigen::Index k = 0; k < size; ++k)
  {
    x[k] = rightHandSide[this->Structure.GetOrder()[k]];
  }
  Vector room(this->Structure.GetMostRows());
  for (const Supernode& node : this->Structure.GetNodes())
  {
    const Eigen::Map<const Dense> block = this->Block(node);
    auto own = x.segment(node.First, node.Width());
    block.topRows(node.Width()).template triangularView<Eigen::Lower>().solveInPlace(own);
    auto below = room.head(static_cast<Index>(node.Rows.size()));
    below.noalias() = block.bottomRows(static_cast<Index>(node.Rows.size())) * own;
    for (std::size_t i = 0; i < node.Rows.size(); ++i)
    {
      x[node.Rows[i]] -= below[static_cast<Index>(i)];
    }
  }
  this->SubstituteBackward(x, this->Structure.GetNodes().size());
  return this->PermutedBack(x);
}

template <typename Scalar>
typename SupernodalCholesky<Scalar>::Vector SupernodalCholesky<Scalar>::Continued(
  const Vector& last) const
{
  Vector x = Vector::Zero(static_cast<Eigen::Index>(this->Structure.GetOrder().size()));
  x.tail(this->Last) = last;
  this->SubstituteBackward(x, this->Structure.GetNodes().size() - (this->Last > 0 ? 1 : 0));
  return this->PermutedBack(x);
}

template <typename Scalar>
void SupernodalCholesky<Scalar>::SubstituteBackward(Vector& x, std::size_t nodes) const
{
  Vector room(this->Structure.GetMostRows());
  for (std::size_t s = nodes; s-- > 0;)
  {
    const Supernode& node = this->Structure.GetNodes()[s];
    const Eigen::Map<const Dense> block = this->Block(node);
    const auto rows = static_cast<Index>(node.Rows.size());
    auto own = x.segment(node.First, node.Width());
    auto below = room.head(rows);
    for (Index i = 0; i < rows; ++i)
    {
      below[i] = x[node.Rows[i]];
    }
    own.noalias() -= block.bottomRows(rows).adjoint() * below;
    block.topRows(node.Width()).template triangularView<Eigen::Lower>().adjoint().solveInPlace(own);
  }
}

template <typename Scalar>
typename SupernodalCholesky<Scalar>::Vector SupernodalCholesky<Scalar>::PermutedBack(
  const Vector& x) const
{
  Vector ordered(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k)
  {
    ordered[this->Structure.GetOrder()[k]] = x[k];
  }
  return ordered;
}

template <typename Scalar>
typename SupernodalCholesky<Scalar>::Dense SupernodalCholesky<Scalar>::TrailingFactor() const
{
  if (this->Last == 0)
  {
    return {};
  }
  return Dense(
    this->Block(this->Structure.GetNodes().back()).template triangularView<Eigen::Lower>());
}

template class SupernodalCholesky<double>;
template class SupernodalCholesky<std::complex<double>>;
}
