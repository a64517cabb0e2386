// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/MergedUnknowns.h"

#include <gtest/gtest.h>

#include <random>

using namespace DirectionFields;

namespace
{
struct Difference
{
  Index A, B;
  double Value;
};

/// Sets of 1, 2, 3 ... unknowns in a random order, each joined along a random tree.
struct Joined
{
  Joined()
    : Sets(Size)
  {
    std::mt19937 random(3);
    std::vector<Index> order(Size);
    for (Index a = 0; a < Size; ++a)
    {
      order[a] = a;
    }
    std::shuffle(order.begin(), order.end(), random);
    for (Index begin = 0, length = 1; begin + length <= Size; begin += length, ++length)
    {
      this->Members.emplace_back(order.begin() + begin, order.begin() + begin + length);
      for (Index k = 1; k < length; ++k)
      {
        const Difference difference{ order[begin + static_cast<Index>(random() % k)],
          order[begin + k], random() / 4294967296.0 };
        this->Differences.push_back(difference);
        this->Sets.Join(difference.A, difference.B, difference.Value);
      }
    }
    this->Sets.Close();
    this->Values = Eigen::VectorXd::NullaryExpr(Size, [&] { return random() / 4294967296.0; });
  }

  static constexpr Index Size = 55;
  MergedUnknowns Sets;
  std::vector<std::vector<Index>> Members;
  std::vector<Difference> Differences;
  Eigen::VectorXd Values;
};
}

TEST(MergedUnknowns, SatisfyAllDifferencesWithTheLeastChange)
{
  Joined joined;
  Eigen::VectorXd values = joined.Values;
  joined.Sets.Satisfy(values);
  for (const Difference& difference : joined.Differences)
  {
    EXPECT_NEAR(values[difference.B] - values[difference.A], difference.Value, 1e-14);
  }
  // The only freedom of a set is a constant, to which the least change is orthogonal.
  for (const std::vector<Index>& set : joined.Members)
  {
    double change = 0.0;
    for (const Index a : set)
    {
      change += values[a] - joined.Values[a];
    }
    EXPECT_NEAR(change, 0.0, 1e-13);
  }
}

TEST(MergedUnknowns, AverageIsTheProjectionToEqualValues)
{
  Joined joined;
  Eigen::VectorXd values = joined.Values;
  joined.Sets.Average(values);
  for (const std::vector<Index>& set : joined.Members)
  {
    double mean = 0.0;
    for (const Index a : set)
    {
      mean += joined.Values[a] / static_cast<double>(set.size());
    }
    for (const Index a : set)
    {
      EXPECT_NEAR(values[a], mean, 1e-14);
    }
  }
  Eigen::VectorXf single = joined.Values.cast<float>();
  joined.Sets.Average(single);
  EXPECT_LT((single.cast<double>() - values).norm(), 1e-5);
}

TEST(MergedUnknowns, TheFirstOfContradictingDifferencesHolds)
{
  MergedUnknowns sets(4);
  EXPECT_FALSE(sets.AreJoined(0, 2));
  sets.Join(0, 1, 1.0);
  sets.Join(2, 1, -2.0);
  EXPECT_TRUE(sets.AreJoined(0, 2));
  EXPECT_FALSE(sets.AreJoined(0, 3));
  sets.Join(0, 2, 100.0);
  sets.Close();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(4);
  sets.Satisfy(values);
  EXPECT_NEAR(values[2] - values[0], 3.0, 1e-15);
  EXPECT_EQ(values[3], 0.0);
}
