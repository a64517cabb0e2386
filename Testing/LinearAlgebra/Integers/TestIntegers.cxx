// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/IntegerElimination.h"
#include "Integers/IntegerRounding.h"
#include "SparseCholesky/SchurSystem.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace DirectionFields;

TEST(IntegerElimination, AnyValuesOfTheFreeVariablesSatisfyAllEquations)
{
  std::mt19937 engine(3);
  for (int round = 0; round < 50; ++round)
  {
    constexpr Index count = 12;
    std::vector<char> isInteger(count);
    for (char& flag : isInteger)
    {
      flag = engine() % 2 == 0 ? 1 : 0;
    }
    IntegerElimination elimination(isInteger);
    std::vector<IntegerSum> rows;
    for (int r = 0; r < 6; ++r)
    {
      IntegerSum row;
      for (int k = 0; k < 4; ++k)
      {
        row.emplace_back(engine() % count, static_cast<std::int64_t>(engine() % 5) - 2);
      }
      rows.push_back(row);
      elimination.Require(row);
    }
    std::vector<std::int64_t> value(elimination.GetNumberOfVariables());
    for (std::int64_t& v : value)
    {
      v = static_cast<std::int64_t>(engine() % 1000) - 500;
    }
    for (const IntegerSum& row : rows)
    {
      std::int64_t sum = 0;
      for (const auto& [variable, factor] : row)
      {
        for (const auto& [free, coefficient] : IntegerSum(elimination.Resolve(variable)))
        {
          ASSERT_TRUE(elimination.IsFree(free));
          sum += factor * coefficient * value[free];
        }
      }
      EXPECT_EQ(sum, 0);
    }
  }
}

TEST(IntegerElimination, ChainsOfEquationsAreSolvedLocally)
{
  // 2 c_k = a_k - a_(k-1): solved for the a_k they would be sums of all c before them.
  constexpr Index count = 40;
  IntegerElimination elimination(std::vector<char>(2 * count, 1));
  for (Index k = 0; k < count; ++k)
  {
    IntegerSum sum = { { k, 2 }, { count + k, -1 } };
    if (k > 0)
    {
      sum.emplace_back(count + k - 1, 1);
    }
    elimination.RequireLocally(sum, k, count + k);
  }
  Index free = 0;
  for (Index v = 0; v < elimination.GetNumberOfVariables(); ++v)
  {
    free += elimination.IsFree(v) ? 1 : 0;
    EXPECT_LE(elimination.Resolve(v).size(), 2U);
  }
  EXPECT_EQ(free, count);
  // Every a is any even number.
  EXPECT_EQ(std::abs(elimination.Resolve(count).front().second), 2);
}

TEST(IntegerRounding, OfIndependentVariablesIsToTheNearest)
{
  Eigen::VectorXd x(4);
  x << 0.4, -1.7, 2.49, 3.0;
  RoundGreedily(Eigen::MatrixXd::Identity(4, 4), x);
  EXPECT_EQ(x, Eigen::Vector4d(0.0, -2.0, 2.0, 3.0));
}

TEST(IntegerRounding, FollowsWhatIsRoundedFirst)
{
  // E = (x - y - 0.6)^2 + (x - 0.1)^2 / 100: x goes to 0 first; y then has to be about -0.6, not its own -0.5.
  Eigen::Matrix2d matrix;
  matrix << 1.01, -1.0, -1.0, 1.0;
  const Eigen::MatrixXd factor = matrix.llt().matrixL();
  Eigen::VectorXd x(2);
  x << 0.1, -0.5;
  RoundGreedily(factor, x);
  EXPECT_EQ(x[0], 0.0);
  EXPECT_EQ(x[1], -1.0);
}

TEST(IntegerRounding, KeepsToBoundsFirst)
{
  // As before, but y is to be at least 1: it goes first, and x follows it to about 1.6.
  Eigen::Matrix2d matrix;
  matrix << 1.01, -1.0, -1.0, 1.0;
  const Eigen::MatrixXd factor = matrix.llt().matrixL();
  Eigen::VectorXd x(2);
  x << 0.1, -0.5;
  const double infinity = std::numeric_limits<double>::infinity();
  RoundGreedily(factor, x, Eigen::Vector2d(-infinity, 1.0));
  EXPECT_EQ(x, Eigen::Vector2d(2.0, 1.0));
}

TEST(IntegerElimination, LeavesBoundedVariablesFree)
{
  IntegerElimination elimination(std::vector<char>(3, 1));
  const Index sum = elimination.AddFreeInteger();
  elimination.Require({ { 0, 1 }, { 1, 1 }, { 2, -1 }, { sum, -1 } });
  EXPECT_TRUE(elimination.IsFree(sum));
  EXPECT_TRUE(elimination.IsInteger(sum));
  EXPECT_EQ(elimination.Resolve(2), (IntegerSum{ { 0, 1 }, { 1, 1 }, { sum, -1 } }));
}

/// As defined: each time the others move to where the energy is least, here by a solution of the
/// equations from the start.
TEST(IntegerRounding, IsGreedyToTheEnd)
{
  constexpr Eigen::Index count = 100;
  std::mt19937 engine(7);
  const auto random = [&]() { return engine() / 4294967296.0 - 0.5; };
  const Eigen::MatrixXd some = Eigen::MatrixXd::NullaryExpr(
    count, count, [&](Eigen::Index, Eigen::Index) { return random(); });
  const Eigen::MatrixXd matrix =
    some * some.transpose() + 0.5 * Eigen::MatrixXd::Identity(count, count);
  const Eigen::VectorXd relaxed =
    Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index) { return 8.0 * random(); });
  Eigen::VectorXd expected = relaxed;
  std::vector<Eigen::Index> left(count);
  std::iota(left.begin(), left.end(), 0);
  std::vector<Eigen::Index> done;
  while (!left.empty())
  {
    const auto next = std::min_element(left.begin(), left.end(),
      [&](Eigen::Index i, Eigen::Index j)
      {
        return std::abs(expected[i] - std::nearbyint(expected[i])) <
          std::abs(expected[j] - std::nearbyint(expected[j]));
      });
    expected[*next] = std::nearbyint(expected[*next]);
    done.push_back(*next);
    left.erase(next);
    // A (x - relaxed) vanishes in the rows that are left.
    const auto size = static_cast<Eigen::Index>(left.size());
    const Eigen::MatrixXd own = Eigen::MatrixXd::NullaryExpr(
      size, size, [&](Eigen::Index i, Eigen::Index j) { return matrix(left[i], left[j]); });
    const Eigen::VectorXd side = Eigen::VectorXd::NullaryExpr(size,
      [&](Eigen::Index i)
      {
        double sum = 0.0;
        for (const Eigen::Index j : done)
        {
          sum -= matrix(left[i], j) * (expected[j] - relaxed[j]);
        }
        return sum;
      });
    const Eigen::VectorXd way = own.ldlt().solve(side);
    for (Eigen::Index i = 0; i < size; ++i)
    {
      expected[left[i]] = relaxed[left[i]] + way[i];
    }
  }
  Eigen::VectorXd x = relaxed;
  RoundGreedily(matrix.llt().matrixL(), x);
  EXPECT_EQ(x, expected);
  EXPECT_NE(x, relaxed.array().round().matrix());
}

TEST(IntegerRounding, OfManyVariablesGivesIntegersNearTheMinimum)
{
  // A chain of springs of length 0.3, in numbers that are rounded in batches.
  constexpr Eigen::Index count = 200;
  Eigen::MatrixXd factor = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 1; i < count; ++i)
  {
    factor(i, i - 1) = -0.5;
  }
  Eigen::VectorXd x(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    x[i] = 0.3 * static_cast<double>(i % 7);
  }
  const Eigen::VectorXd before = x;
  RoundGreedily(factor, x, {}, 50);
  EXPECT_TRUE((x.array() == x.array().round()).all());
  const double energy = (factor.transpose() * (x - before)).squaredNorm();
  const double allAtOnce =
    (factor.transpose() * (before.array().round().matrix() - before)).squaredNorm();
  EXPECT_LE(energy, allAtOnce);
}

TEST(SchurSystem, SolvesAmongIntegers)
{
  // Springs in a row between 0 and 10, of which the third of four joints is an integer.
  Eigen::Matrix4d springs;
  springs << 2.0, 0.0, 0.0, 0.0, -1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, -1.0, -1.0, 2.0;
  const SchurSystem::Matrix lower = springs.sparseView();
  SchurSystem system(lower, 3);
  ASSERT_TRUE(system.IsDefinite());
  Eigen::VectorXd side(4);
  side << 0.0, 0.0, 10.0, 0.0;
  // In the order 0, 1, 3, 2 along the row.
  const Eigen::VectorXd relaxed = system.Solve(side);
  EXPECT_LT((relaxed - Eigen::Vector4d(2.0, 4.0, 8.0, 6.0)).norm(), 1e-12);
  const Eigen::VectorXd bent = system.SolveWith(relaxed, Eigen::VectorXd::Constant(1, 3.0));
  EXPECT_LT((bent - Eigen::Vector4d(1.0, 2.0, 6.5, 3.0)).norm(), 1e-12);
  // What is left of the matrix once the others are eliminated: 2 - 2/3 - 1/2.
  EXPECT_NEAR(std::pow(system.TrailingFactor()(0, 0), 2), 5.0 / 6.0, 1e-12);
  // A factor that was released is the same when it is made again, and nothing is made again where it is kept.
  for (const std::size_t mostKept : { 0, 100 })
  {
    system.Shrink(mostKept);
    system.Restore();
    EXPECT_EQ(system.Solve(side), relaxed);
  }
  side *= 0.9;
  const Eigen::VectorXd rounded = SolveInRounds(lower, side, 3);
  EXPECT_EQ(rounded[3], 5.0);
  EXPECT_NEAR(rounded[1], 10.0 / 3.0, 1e-12);
}
