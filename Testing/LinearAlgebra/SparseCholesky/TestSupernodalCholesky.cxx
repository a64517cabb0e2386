// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SupernodalCholesky.h"
#include "Support/Threads.h"

#include <Eigen/Dense>
#include <Eigen/OrderingMethods>

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Matrix = SupernodalCholesky::Matrix;

/// The lower triangle of the Laplacian of a grid plus the identity, some of whose rows, the last ones, are coupled with
/// rows anywhere.
Matrix Grid(Index side, Index last, unsigned seed)
{
  std::mt19937 engine(seed);
  const Index cells = side * side;
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  const auto couple = [&](Index i, Index j, double weight)
  {
    entries.emplace_back(i, i, weight);
    entries.emplace_back(j, j, weight);
    entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
  };
  for (Index i = 0; i < cells; ++i)
  {
    if (i % side + 1 < side)
    {
      couple(i, i + 1, 1.0 + engine() % 8);
    }
    if (i + side < cells)
    {
      couple(i, i + side, 1.0 + engine() % 8);
    }
  }
  for (Index k = 0; k < last; ++k)
  {
    for (int c = 0; c < 6; ++c)
    {
      couple(cells + k, static_cast<Index>(engine() % cells), 1.0);
    }
  }
  for (Index i = 0; i < cells + last; ++i)
  {
    entries.emplace_back(i, i, 1e-3);
  }
  Matrix lower(cells + last, cells + last);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/// An order of the first rows that keeps the factor sparse, and the last ones.
std::vector<std::int32_t> OrderFor(const Matrix& lower, Index last)
{
  const auto first = static_cast<Index>(lower.rows()) - last;
  std::vector<std::int32_t> order(lower.rows());
  std::iota(order.begin(), order.end(), 0);
  const Matrix block = lower.topLeftCorner(first, first);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> least;
  Eigen::AMDOrdering<std::int32_t>()(block.selfadjointView<Eigen::Lower>(), least);
  std::copy_n(least.indices().data(), first, order.begin());
  return order;
}
}

TEST(SupernodalCholesky, SolvesAndLeavesTheSchurComplement)
{
  for (const Index last : { 0, 1, 7, 40 })
  {
    for (const Index side : { 1, 3, 24 })
    {
      const Matrix lower = Grid(side, last, 7U * side + last);
      SupernodalCholesky factor;
      ASSERT_TRUE(factor.Compute(lower, OrderFor(lower, last), last));
      const Eigen::MatrixXd whole = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
      const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(whole.rows(), -1.0, 2.0);
      EXPECT_LT((factor.Solve(whole * x) - x).norm(), 1e-10 * x.norm());
      const Index first = side * side;
      ASSERT_EQ(factor.TrailingFactor().rows(), last);
      if (last == 0)
      {
        continue;
      }
      const Eigen::MatrixXd schur = whole.bottomRightCorner(last, last) -
        whole.bottomLeftCorner(last, first) *
          whole.topLeftCorner(first, first).llt().solve(whole.topRightCorner(first, last));
      const Eigen::MatrixXd trailing = factor.TrailingFactor();
      EXPECT_LE((trailing * trailing.transpose() - schur).norm(), 1e-10 * (1.0 + schur.norm()));
      EXPECT_TRUE(trailing.isLowerTriangular(0.0));
    }
  }
}

TEST(SupernodalCholesky, GivesTheSameBytesForAnyThreads)
{
  const Matrix lower = Grid(90, 20, 3);
  const Eigen::VectorXd side = Eigen::VectorXd::LinSpaced(lower.rows(), -1.0, 2.0);
  std::vector<Eigen::VectorXd> solutions;
  for (const int number : { 1, 2, 5 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    SupernodalCholesky factor;
    ASSERT_TRUE(factor.Compute(lower, OrderFor(lower, 20), 20));
    solutions.push_back(factor.Solve(side));
    EXPECT_EQ(solutions.back(), solutions.front());
  }
}

TEST(SupernodalCholesky, TellsWhatIsNotDefinite)
{
  Matrix lower = Grid(20, 5, 1);
  SupernodalCholesky factor;
  ASSERT_TRUE(factor.Compute(lower, OrderFor(lower, 5), 5));
  for (const Index row : { 0, 210, 404 })
  {
    Matrix other = lower;
    other.coeffRef(row, row) = -1.0;
    EXPECT_FALSE(factor.Compute(other, OrderFor(lower, 5), 5));
  }
}
