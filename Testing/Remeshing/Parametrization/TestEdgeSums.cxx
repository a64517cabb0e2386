// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/EdgeSums.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

using namespace DirectionFields::Internal;
using DirectionFields::Index;

TEST(EdgeSums, SquaresAreTheProductsOfAllPairsOfTerms)
{
  constexpr Index variables = 30;
  constexpr std::size_t edges = 200;
  constexpr double mixed = 0.5;
  std::mt19937 engine(1);
  EdgeSums sums;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(variables, variables);
  for (std::size_t e = 0; e < edges; ++e)
  {
    // Few terms or many.
    const unsigned part = e % 20 == 0 ? 2 : 15;
    std::array<std::vector<EdgeSums::Term>, 2> coordinates;
    std::array<Eigen::VectorXd, 2> dense;
    for (int i = 0; i < 2; ++i)
    {
      dense[i] = Eigen::VectorXd::Zero(variables);
      for (Index v = 0; v < variables; ++v)
      {
        if (engine() % part == 0)
        {
          dense[i][v] = static_cast<double>(engine() % 5) - 2.0;
          coordinates[i].push_back({ v, dense[i][v] });
        }
      }
    }
    const double weight = 1.0 + static_cast<double>(engine() % 3);
    sums.Append(weight, coordinates);
    expected += weight *
      (dense[0] * dense[0].transpose() + dense[1] * dense[1].transpose() +
        mixed * (dense[0] * dense[1].transpose() + dense[1] * dense[0].transpose()));
  }
  const Eigen::MatrixXd lower = sums.Squares(variables, mixed);
  const Eigen::MatrixXd below = expected.triangularView<Eigen::Lower>();
  EXPECT_LT((lower - below).norm(), 1e-9);
}

TEST(EdgeSums, ManyLongSumsMakeNoMoreThanOneMatrix)
{
  // 10 000 edges of 200 terms each: 4e8 pairs of terms, of 200 variables.
  constexpr Index variables = 200;
  std::array<std::vector<EdgeSums::Term>, 2> coordinates;
  for (Index v = 0; v < variables; ++v)
  {
    coordinates[0].push_back({ v, 1.0 });
  }
  EdgeSums sums;
  for (int e = 0; e < 10000; ++e)
  {
    sums.Append(1.0, coordinates);
  }
  EXPECT_EQ(sums.GetNumberOfTerms(), 10000u * variables);
  const SchurSystem::Matrix lower = sums.Squares(variables, 0.0);
  EXPECT_EQ(lower.nonZeros(), variables * (variables + 1) / 2);
  EXPECT_EQ(lower.coeff(variables - 1, 0), 10000.0);
}
