// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/IntegerRounding.h"

#include "Integers/TriangularSquares.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
/// Distance to the nearest integer; values below their bound come before all others.
double Rank(double x, double least)
{
  return std::nearbyint(x) < least ? x - least : std::abs(x - std::nearbyint(x));
}

/// How the variables that are left depend on each other, in their order. What they no longer depend
/// on is subtracted for many variables at once, which costs as much as for a few.
class Covariance
{
public:
  explicit Covariance(const Eigen::MatrixXd& factor)
    : Former(InverseSquareOf(factor))
    , Columns(factor.rows(), MostWaiting)
    , Left(factor.rows())
  {
  }

  Eigen::VectorXd Column(Eigen::Index k) const
  {
    Eigen::VectorXd column = this->Former.col(k).head(this->Left);
    if (this->Waiting > 0)
    {
      column.noalias() -= this->Scaled() * this->Columns.row(k).head(this->Waiting).transpose();
    }
    return column;
  }

  /// Subtracts what depends on a variable, of which this is the column.
  void Fix(const Eigen::VectorXd& column, double variance)
  {
    this->Columns.col(this->Waiting).head(this->Left) = column / std::sqrt(variance);
    ++this->Waiting;
    if (this->Waiting == MostWaiting)
    {
      this->Subtract();
    }
  }

  /// Takes a variable out; the last one takes its place.
  void Remove(Eigen::Index k)
  {
    --this->Left;
    this->Former.col(k).head(this->Left + 1) = this->Former.col(this->Left).head(this->Left + 1);
    this->Former.row(k).head(this->Left) = this->Former.row(this->Left).head(this->Left);
    this->Columns.row(k) = this->Columns.row(this->Left);
  }

  /// The matrix, of the variables that are left in its first rows and columns.
  const Eigen::MatrixXd& Get()
  {
    this->Subtract();
    return this->Former;
  }

private:
  static constexpr Eigen::Index MostWaiting = 32;
  static constexpr Eigen::Index PieceSize = 64;

  Eigen::Block<const Eigen::MatrixXd> Scaled() const
  {
    return this->Columns.topLeftCorner(this->Left, this->Waiting);
  }

  void Subtract()
  {
    ParallelFor(static_cast<Index>(this->Left), static_cast<Index>(PieceSize),
      [&](Index begin, Index end)
      {
        this->Former.block(0, begin, this->Left, end - begin).noalias() -=
          this->Scaled() * this->Scaled().middleRows(begin, end - begin).transpose();
      });
    this->Waiting = 0;
  }

  Eigen::MatrixXd Former;
  /// What is to be subtracted is this times its transpose.
  Eigen::MatrixXd Columns;
  Eigen::Index Left;
  Eigen::Index Waiting = 0;
};

/// The variables to be rounded next among the remaining ones.
std::vector<Eigen::Index> NextOnes(Covariance& among, const Eigen::VectorXd& x,
  const Eigen::VectorXd& least, const std::vector<Eigen::Index>& left, Eigen::Index mostSingly)
{
  const Eigen::Index count = static_cast<Eigen::Index>(left.size());
  // The rank, the variable, and its place among the remaining ones.
  std::vector<std::tuple<double, Eigen::Index, Eigen::Index>> order;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    order.push_back({ Rank(x[left[i]], least[left[i]]), left[i], i });
  }
  if (count <= mostSingly)
  {
    return { std::get<2>(*std::min_element(order.begin(), order.end())) };
  }
  // First the variables so near an integer that no other rounding changes it, then the ones
  // independent of them.
  std::sort(order.begin(), order.end());
  constexpr double mostCorrelated = 0.1;
  constexpr std::size_t mostCompared = 256;
  const Eigen::MatrixXd& covariance = among.Get();
  std::vector<Eigen::Index> batch;
  for (Eigen::Index i = 0; i < (count + 2) / 3 && batch.size() < mostCompared; ++i)
  {
    const Eigen::Index k = std::get<2>(order[i]);
    const bool isApart = std::all_of(batch.begin(), batch.end(),
      [&](Eigen::Index j)
      {
        return std::abs(covariance(j, k)) <
          mostCorrelated * std::sqrt(covariance(j, j) * covariance(k, k));
      });
    if (isApart)
    {
      batch.push_back(k);
    }
  }
  return batch;
}
}

void RoundGreedily(const Eigen::MatrixXd& factor, Eigen::VectorXd& x, const Eigen::VectorXd& least,
  Eigen::Index mostSingly)
{
  const Eigen::Index count = x.size();
  const Eigen::VectorXd bound = least.size() == count
    ? least
    : Eigen::VectorXd::Constant(count, -std::numeric_limits<double>::infinity());
  Covariance covariance(factor);
  std::vector<Eigen::Index> left(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    left[i] = i;
  }
  while (!left.empty())
  {
    std::vector<Eigen::Index> slots = NextOnes(covariance, x, bound, left, mostSingly);
    std::sort(slots.begin(), slots.end(), std::greater<>());
    for (const Eigen::Index k : slots)
    {
      const double target = std::max(std::nearbyint(x[left[k]]), bound[left[k]]);
      const Eigen::VectorXd column = covariance.Column(k);
      const double variance = column[k];
      if (variance > 0.0)
      {
        const double step = (target - x[left[k]]) / variance;
        for (Eigen::Index i = 0; i < column.size(); ++i)
        {
          x[left[i]] += step * column[i];
        }
        covariance.Fix(column, variance);
      }
      x[left[k]] = target;
      covariance.Remove(k);
      left[k] = left.back();
      left.pop_back();
    }
  }
}
}
