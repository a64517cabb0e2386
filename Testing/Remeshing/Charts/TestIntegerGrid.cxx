// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/IntegerGrid.h"

#include <gtest/gtest.h>

#include <random>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
class Random
{
public:
  GridPoint Point(std::int64_t range) { return { this->Number(range), this->Number(range) }; }
  Transition Map(int degree)
  {
    return { static_cast<int>(this->Engine() % degree),
      { IntegerGrid::Unit * this->Number(50), IntegerGrid::Unit * this->Number(50) } };
  }

private:
  std::int64_t Number(std::int64_t range)
  {
    return static_cast<std::int64_t>(this->Engine() % (2 * range + 1)) - range;
  }
  std::mt19937_64 Engine{ 5 };
};

constexpr std::int64_t Far = std::int64_t(1) << 36;
}

TEST(IntegerGrid, TransitionsAreAGroupThatActsOnThePlane)
{
  for (const int degree : { 4, 6 })
  {
    const IntegerGrid plane(degree);
    Random random;
    for (int k = 0; k < 200; ++k)
    {
      const Transition s = random.Map(degree);
      const Transition t = random.Map(degree);
      const GridPoint p = random.Point(Far);
      EXPECT_EQ(plane.Apply(plane.Composed(s, t), p), plane.Apply(s, plane.Apply(t, p)));
      EXPECT_EQ(plane.Composed(plane.Inverse(s), s), Transition());
      EXPECT_EQ(plane.Composed(s, plane.Inverse(s)), Transition());
      EXPECT_EQ(plane.Turned(p, degree), p);
      EXPECT_EQ(plane.Turned(p, degree / 2), -p);
    }
  }
}

TEST(IntegerGrid, TurningIsMultiplicationByARootOfUnity)
{
  for (const int degree : { 4, 6 })
  {
    const IntegerGrid plane(degree);
    Random random;
    for (int k = -degree; k <= degree; ++k)
    {
      const GridPoint p = random.Point(IntegerGrid::Unit * 10);
      EXPECT_LT(std::abs(plane.Place(plane.Turned(p, k)) - plane.Root(k) * plane.Place(p)), 1e-12);
      const Complex z = plane.Place(p);
      const std::array<double, 2> coordinates = plane.Coordinates(z);
      EXPECT_LT(std::abs(plane.Combined(coordinates[0], coordinates[1]) - z), 1e-12);
    }
  }
}

TEST(IntegerGrid, OrientationIsExactWhereDoublesAreNot)
{
  // Twice the area of this triangle is 1, the difference of two products of 2^72.
  const GridPoint origin;
  const GridPoint p{ Far, Far - 1 };
  const GridPoint q{ Far + 1, Far };
  EXPECT_EQ(IntegerGrid::Orientation(origin, p, q), 1);
  EXPECT_EQ(IntegerGrid::Orientation(origin, q, p), -1);
  EXPECT_EQ(IntegerGrid::Orientation(origin, p, p + p), 0);
  Random random;
  for (int k = 0; k < 200; ++k)
  {
    const GridPoint a = random.Point(Far);
    const GridPoint b = random.Point(Far);
    const GridPoint c = random.Point(Far);
    const int sign = IntegerGrid::Orientation(a, b, c);
    EXPECT_EQ(IntegerGrid::Orientation(b, c, a), sign);
    EXPECT_EQ(IntegerGrid::Orientation(b, a, c), -sign);
  }
}

TEST(IntegerGrid, UnitCellsLieOnCircles)
{
  const std::int64_t u = IntegerGrid::Unit;
  // The fourth corner of a square lies on the circle through the others: not inside, but one step
  // further inwards is.
  const IntegerGrid squares(4);
  EXPECT_FALSE(squares.IsInCircle({ 0, 0 }, { u, 0 }, { u, u }, { 0, u }));
  EXPECT_TRUE(squares.IsInCircle({ 0, 0 }, { u, 0 }, { u, u }, { 1, u - 1 }));
  EXPECT_FALSE(squares.IsInCircle({ 0, 0 }, { u, 0 }, { u, u }, { -1, u + 1 }));
  // Of the hexagon around 0 likewise.
  const IntegerGrid triangles(6);
  const GridPoint one{ u, 0 };
  const GridPoint fourth = triangles.Turned(one, 3);
  const GridPoint second = triangles.Turned(one, 1);
  const GridPoint third = triangles.Turned(one, 2);
  EXPECT_FALSE(triangles.IsInCircle(one, second, third, fourth));
  EXPECT_TRUE(triangles.IsInCircle(one, second, third, fourth + GridPoint{ 1, 0 }));
  EXPECT_FALSE(triangles.IsInCircle(one, second, third, fourth - GridPoint{ 1, 0 }));
}
