// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SupernodalCholesky.h"
#include "Support/Threads.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <type_traits>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
template <typename Scalar>
class SupernodalCholeskyOf : public testing::Test
{
public:
  using Factor = SupernodalCholesky<Scalar>;
  using Matrix = typename Factor::Matrix;
  using Vector = typename Factor::Vector;
  using Dense = typename Factor::Dense;

  /// A number of modulus 1.
  static Scalar Unit(std::mt19937& engine)
  {
    const double angle = engine() / 4294967296.0 * 2.0 * Pi;
    if constexpr (std::is_same_v<Scalar, double>)
    {
      return angle < Pi ? 1.0 : -1.0;
    }
    else
    {
      return std::polar(1.0, angle);
    }
  }

  static Vector Units(Eigen::Index size)
  {
    std::mt19937 engine(7);
    Vector units(size);
    for (Scalar& unit : units)
    {
      unit = Unit(engine);
    }
    return units;
  }

  /// The lower triangle of the connection Laplacian of a grid plus a little of the identity. The
  /// last rows are coupled with rows anywhere.
  static Matrix Grid(Index side, Index last, unsigned seed)
  {
    std::mt19937 engine(seed);
    const Index cells = side * side;
    std::vector<Eigen::Triplet<Scalar, std::int32_t>> entries;
    const auto couple = [&](Index i, Index j, double weight)
    {
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
      entries.emplace_back(std::max(i, j), std::min(i, j), -weight * Unit(engine));
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
};
using Scalars = testing::Types<double, Complex>;
TYPED_TEST_SUITE(SupernodalCholeskyOf, Scalars, );
}

TYPED_TEST(SupernodalCholeskyOf, SolvesAndLeavesTheSchurComplement)
{
  for (const Index last : { 0, 1, 7, 40 })
  {
    for (const Index side : { 1, 3, 24 })
    {
      const auto lower = this->Grid(side, last, 7U * side + last);
      typename TestFixture::Factor factor;
      ASSERT_TRUE(factor.Compute(lower, last));
      const typename TestFixture::Dense whole =
        typename TestFixture::Dense(lower).template selfadjointView<Eigen::Lower>();
      const auto x = this->Units(whole.rows());
      EXPECT_LT((factor.Solve(whole * x) - x).norm(), 1e-10 * x.norm());
      const Index first = side * side;
      ASSERT_EQ(factor.TrailingFactor().rows(), last);
      if (last == 0)
      {
        continue;
      }
      const typename TestFixture::Dense schur = whole.bottomRightCorner(last, last) -
        whole.bottomLeftCorner(last, first) *
          whole.topLeftCorner(first, first).llt().solve(whole.topRightCorner(first, last));
      const auto trailing = factor.TrailingFactor();
      EXPECT_LE((trailing * trailing.adjoint() - schur).norm(), 1e-10 * (1.0 + schur.norm()));
      EXPECT_TRUE(trailing.isLowerTriangular(0.0));
      // The last rows of the solution change by one unit each, and the others so that their
      // equations still hold.
      const auto change = factor.Continued(this->Units(last));
      EXPECT_EQ(change.tail(last), this->Units(last));
      EXPECT_LT((whole * change).head(first).norm(), 1e-10 * whole.norm());
    }
  }
}

/// L L^* = K, where no row is put in another place.
TYPED_TEST(SupernodalCholeskyOf, TimesItsAdjointIsTheMatrix)
{
  const auto lower = this->Grid(9, 30, 5);
  typename TestFixture::Factor factor;
  ASSERT_TRUE(factor.Compute(lower, static_cast<Index>(lower.rows())));
  const typename TestFixture::Dense whole =
    typename TestFixture::Dense(lower).template selfadjointView<Eigen::Lower>();
  const auto trailing = factor.TrailingFactor();
  EXPECT_LT((trailing * trailing.adjoint() - whole).norm(), 1e-14 * whole.norm());
  EXPECT_EQ(factor.GetNumberOfValues(), static_cast<std::size_t>(whole.size()));
}

TYPED_TEST(SupernodalCholeskyOf, LooksAtTheLowerTriangleAlone)
{
  const auto lower = this->Grid(24, 7, 2);
  const typename TestFixture::Matrix whole = lower.template selfadjointView<Eigen::Lower>();
  typename TestFixture::Factor half;
  typename TestFixture::Factor full;
  ASSERT_TRUE(half.Compute(lower));
  ASSERT_TRUE(full.Compute(whole));
  EXPECT_EQ(half.Solve(this->Units(lower.rows())), full.Solve(this->Units(lower.rows())));
}

TYPED_TEST(SupernodalCholeskyOf, GivesTheSameBytesForAnyThreads)
{
  const auto lower = this->Grid(90, 20, 3);
  std::vector<typename TestFixture::Vector> solutions;
  for (const int number : { 1, 2, 5 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    typename TestFixture::Factor factor;
    ASSERT_TRUE(factor.Compute(lower, 20));
    solutions.push_back(factor.Solve(this->Units(lower.rows())));
    EXPECT_EQ(solutions.back(), solutions.front());
    factor.ReleaseValues();
    factor.FactorAgain(lower);
    EXPECT_EQ(factor.Solve(this->Units(lower.rows())), solutions.front());
  }
}

TYPED_TEST(SupernodalCholeskyOf, TellsWhatIsNotDefinite)
{
  auto lower = this->Grid(20, 5, 1);
  typename TestFixture::Factor factor;
  ASSERT_TRUE(factor.Compute(lower, 5));
  for (const Index row : { 0, 210, 404 })
  {
    for (const double diagonal : { -1.0, 0.0, std::numeric_limits<double>::quiet_NaN() })
    {
      auto other = lower;
      other.coeffRef(row, row) = diagonal;
      EXPECT_FALSE(factor.Compute(other, 5));
    }
  }
}

TYPED_TEST(SupernodalCholeskyOf, IsGivenUpWhenTold)
{
  const auto lower = this->Grid(150, 20, 4);
  typename TestFixture::Factor plain;
  ASSERT_TRUE(plain.Compute(lower, 20));
  for (const int number : { 1, 2 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    // Beside another thread that does all the work the calling one may ask no third time.
    for (int most = 1; most <= 4 - number; ++most)
    {
      int calls = 0;
      const ProgressFunction stop = [&](double) { return ++calls < most; };
      typename TestFixture::Factor factor;
      EXPECT_THROW(factor.Compute(lower, 20, Progress(stop)), Stopped);
      EXPECT_EQ(calls, most);
      struct Trouble
      {
      };
      calls = 0;
      const ProgressFunction trouble = [&](double) -> bool
      { return ++calls < most ? true : throw Trouble(); };
      EXPECT_THROW(factor.Compute(lower, 20, Progress(trouble)), Trouble);
    }
    // Questions leave the factor as it is without.
    const ProgressFunction goOn = [](double) { return true; };
    typename TestFixture::Factor asked;
    ASSERT_TRUE(asked.Compute(lower, 20, Progress(goOn)));
    EXPECT_EQ(asked.Solve(this->Units(lower.rows())), plain.Solve(this->Units(lower.rows())));
  }
}
