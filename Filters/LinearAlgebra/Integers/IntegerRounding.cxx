// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/IntegerRounding.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
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

/// The variables to be rounded next among the remaining ones.
std::vector<Eigen::Index> NextOnes(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& x,
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
  const Eigen::MatrixXd inverse =
    factor.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(count, count));
  Eigen::MatrixXd covariance = inverse.transpose() * inverse;
  std::vector<Eigen::Index> left(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    left[i] = i;
  }
  while (!left.empty())
  {
    // The covariance of the remaining variables stands in the first rows and columns, in their
    // order.
    std::vector<Eigen::Index> slots = NextOnes(covariance, x, bound, left, mostSingly);
    std::sort(slots.begin(), slots.end(), std::greater<>());
    for (const Eigen::Index k : slots)
    {
      const auto size = static_cast<Eigen::Index>(left.size());
      const double target = std::max(std::nearbyint(x[left[k]]), bound[left[k]]);
      const Eigen::VectorXd column = covariance.col(k).head(size);
      const double variance = column[k];
      if (variance > 0.0)
      {
        const double step = (target - x[left[k]]) / variance;
        for (Eigen::Index i = 0; i < size; ++i)
        {
          x[left[i]] += step * column[i];
        }
        covariance.topLeftCorner(size, size).noalias() -= (column / variance) * column.transpose();
      }
      x[left[k]] = target;
      // The last one takes its place.
      covariance.col(k).head(size) = covariance.col(size - 1).head(size);
      covariance.row(k).head(size) = covariance.row(size - 1).head(size);
      left[k] = left.back();
      left.pop_back();
    }
  }
}
}
