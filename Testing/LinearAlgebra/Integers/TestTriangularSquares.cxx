// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/TriangularSquares.h"

#include "Support/Threads.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <random>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// Random below the diagonal, which is 1 to 2. What is above is not to be read.
Eigen::MatrixXd LowerTriangle(Eigen::Index count)
{
  std::mt19937 engine(static_cast<unsigned>(count));
  const auto random = [&]() { return engine() / 4294967296.0; };
  Eigen::MatrixXd lower = Eigen::MatrixXd::Constant(count, count, 1e30);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    lower(j, j) = 1.0 + random();
    for (Eigen::Index i = j + 1; i < count; ++i)
    {
      lower(i, j) = (random() - 0.5) / 8.0;
    }
  }
  return lower;
}
}

/// Of one block, of whole blocks, and of blocks and a rest.
TEST(TriangularSquares, AreTheProductAndItsInverse)
{
  for (const Eigen::Index count : { 0, 1, 5, 64, 65, 128, 201 })
  {
    const Eigen::MatrixXd lower = LowerTriangle(count);
    const Eigen::MatrixXd factor = lower.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd square = SquareOf(lower);
    const Eigen::MatrixXd inverse = InverseSquareOf(lower);
    EXPECT_LE((square - factor * factor.transpose()).norm(), 1e-13 * square.norm()) << count;
    EXPECT_LE((inverse * square - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-11) << count;
    EXPECT_EQ(square, square.transpose());
    EXPECT_EQ(inverse, inverse.transpose());
  }
}

TEST(TriangularSquares, AreTheSameForAnyNumberOfThreads)
{
  const Eigen::MatrixXd lower = LowerTriangle(300);
  const Eigen::MatrixXd square = SquareOf(lower);
  const Eigen::MatrixXd inverse = InverseSquareOf(lower);
  for (const int number : { 2, 3 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    EXPECT_EQ(SquareOf(lower), square);
    EXPECT_EQ(InverseSquareOf(lower), inverse);
  }
}
