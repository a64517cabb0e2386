// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/IntegerRounding.h"
#include "Integers/IntegerSearch.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr Eigen::Index Count = 5;

/// An energy whose variables depend on each other as much as those of a map do, and its minimum.
struct Example
{
  explicit Example(int seed)
  {
    std::mt19937 engine(seed);
    const auto random = [&] { return engine() / 4294967296.0; };
    for (Eigen::Index i = 0; i < Count; ++i)
    {
      for (Eigen::Index j = 0; j < i; ++j)
      {
        this->Factor(i, j) = random() - 0.5;
      }
      this->Factor(i, i) = 0.05 + 0.5 * random();
      this->Relaxed[i] = 2.0 * random();
    }
  }

  double Energy(const Eigen::VectorXd& x) const
  {
    return (this->Factor.transpose() * (x - this->Relaxed)).squaredNorm();
  }

  /// Of all integers up to 3 away.
  double LeastEnergy(double least) const
  {
    double energy = std::numeric_limits<double>::infinity();
    constexpr int width = 7;
    const int all = static_cast<int>(std::lround(std::pow(width, Count)));
    for (int k = 0; k < all; ++k)
    {
      Eigen::VectorXd x(Count);
      for (int i = 0, rest = k; i < Count; ++i, rest /= width)
      {
        x[i] = std::max(least, std::nearbyint(this->Relaxed[i]) + rest % width - width / 2);
      }
      energy = std::min(energy, this->Energy(x));
    }
    return energy;
  }

  Eigen::MatrixXd Factor = Eigen::MatrixXd::Zero(Count, Count);
  Eigen::VectorXd Relaxed = Eigen::VectorXd::Zero(Count);
};
}

TEST(IntegerSearch, MissesTheLeastEnergyHalfAsOftenAsRoundingAtMost)
{
  for (const double bound : { -std::numeric_limits<double>::infinity(), 1.0 })
  {
    const Eigen::VectorXd least = Eigen::VectorXd::Constant(Count, bound);
    int rounded = 0;
    int searched = 0;
    constexpr int examples = 20;
    for (int seed = 1; seed <= examples; ++seed)
    {
      const Example example(seed);
      const double optimum = 1.000001 * example.LeastEnergy(bound);
      Eigen::VectorXd x = example.Relaxed;
      RoundGreedily(example.Factor, x, least);
      const double before = example.Energy(x);
      rounded += before <= optimum ? 1 : 0;
      ImproveIntegers(example.Factor, example.Relaxed, x, least);
      EXPECT_TRUE((x.array() == x.array().round()).all());
      EXPECT_GE(x.minCoeff(), bound);
      EXPECT_LE(example.Energy(x), before);
      searched += example.Energy(x) <= optimum ? 1 : 0;
    }
    EXPECT_LT(rounded, examples);
    EXPECT_LE(2 * (examples - searched), examples - rounded);
  }
}

TEST(IntegerSearch, LeavesTheLeastEnergyAsItIs)
{
  Eigen::VectorXd x = Eigen::Vector3d(0.0, -2.0, 3.0);
  const Eigen::Vector3d relaxed(0.4, -1.7, 3.5);
  ImproveIntegers(Eigen::MatrixXd::Identity(3, 3), relaxed, x);
  EXPECT_EQ(x, Eigen::Vector3d(0.0, -2.0, 3.0));
  x = Eigen::VectorXd();
  ImproveIntegers(Eigen::MatrixXd(), Eigen::VectorXd(), x);
  EXPECT_EQ(x.size(), 0);
}
