// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Drawing/Stripes/Patterns.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Patterns;

namespace
{
/// A ring in the plane z = 0 between two radii.
Surface Ring(int around, int across, double inner, double outer)
{
  Surface surface = Meshes::Cylinder(around, across, 1.0);
  for (Vector3& p : surface.Points)
  {
    const double radius = inner + (outer - inner) * p.z();
    p = Vector3(p.x(), p.y(), 0.0).normalized() * radius;
  }
  return surface;
}

}

TEST(Stripes, OnClosedSurfacesTheIndicesOfVectorFieldsAddUpToZero)
{
  for (const Surface& surface : { Meshes::Icosphere(4), Meshes::Torus(64, 32), Meshes::Potato(4) })
  {
    for (const StripeDirection direction : { StripeDirection::Along, StripeDirection::Across })
    {
      const StripePattern pattern = SmoothPattern(surface, 1, Spaced(0.15, direction));
      EXPECT_GT(pattern.Length.size(), 0u);
      EXPECT_EQ(IndexSum(pattern), 0);
    }
  }
}

TEST(Stripes, OfAFieldThatIntegratesHaveNoBranchPoints)
{
  const Surface torus = Meshes::Torus(96, 48);
  const StripePattern around = PatternOf(torus, East(torus), Spaced(0.25));
  EXPECT_EQ(around.Singularities.size(), 0u);
  EXPECT_LT(around.Misfit, 0.02);
  // The lines are circles, round(2 pi 0.4 / 0.25) of them.
  EXPECT_EQ(around.Length.size(), 10u);
  EXPECT_EQ(std::count(around.Closed.begin(), around.Closed.end(), 1), 10);

  const Surface square = Meshes::Square(20);
  const auto oblique = [](const Vector3&) { return 0.3; };
  for (const int degree : { 1, 2 })
  {
    const StripePattern straight =
      PatternOf(square, Fields::PlanarField(square, degree, oblique), Spaced(0.1));
    EXPECT_EQ(straight.Singularities.size(), 0u);
    EXPECT_LT(straight.Misfit, 1e-3);
    EXPECT_NEAR(LengthOf(straight) * 0.1, 1.0, 0.02);
    const Vector3 along(std::cos(0.3), std::sin(0.3), 0.0);
    for (std::size_t i = 0; i + 1 < straight.LineOffsets.size(); ++i)
    {
      const Vector3 line = straight.LinePositions[straight.LineOffsets[i + 1] - 1] -
        straight.LinePositions[straight.LineOffsets[i]];
      EXPECT_GT(std::abs(line.dot(along)), (1.0 - 1e-4) * line.norm());
      if (degree == 1)
      {
        EXPECT_GT(line.dot(along), 0.0) << "lines run with the field";
      }
    }
  }
}

TEST(Stripes, OnTheSphereBranchAsOftenAsTheirNumberChanges)
{
  // The stripes across the equator are as many as fit around it, and half a sphere has to lose them
  // all.
  const Surface sphere = Meshes::Icosphere(5);
  for (const double frequency : { 6.0, 12.0 })
  {
    const StripePattern pattern =
      PatternOf(sphere, East(sphere), Spaced(1.0 / frequency, StripeDirection::Across));
    EXPECT_NEAR(pattern.BranchPoints, 4.0 * Pi * frequency, 0.1 * 4.0 * Pi * frequency);
  }
}

TEST(Stripes, OfARingGainInTheMiddleWhatTheirNumberAtTheBoundaryChangesBy)
{
  const Surface ring = Ring(160, 40, 0.5, 1.5);
  const StripePattern pattern =
    PatternOf(ring, East(ring), Spaced(1.0 / 8.0, StripeDirection::Across));
  // Lines run with higher phases to their left: those that begin at the boundary begin at the inner
  // or the outer one.
  int balance = 0;
  for (std::size_t i = 0; i < pattern.Closed.size(); ++i)
  {
    for (int e = 0; e < 2; ++e)
    {
      if (!pattern.Closed[i] && pattern.EndSingularities[i][e] == None)
      {
        balance += e == 0 ? -1 : 1;
        const Vector3& end =
          pattern.LinePositions[e == 0 ? pattern.LineOffsets[i] : pattern.LineOffsets[i + 1] - 1];
        EXPECT_TRUE(std::abs(end.norm() - 0.5) < 1e-2 || std::abs(end.norm() - 1.5) < 1e-2);
      }
    }
  }
  EXPECT_EQ(IndexSum(pattern), balance);
  // 8 2 pi (1.5 - 0.5) are due; free boundaries expel some.
  EXPECT_GT(std::abs(balance), 0.55 * 50.3);
  EXPECT_LE(std::abs(balance), 1.0 * 50.3);
}

TEST(Stripes, EachLineIsClosedOrEndsAtASingularityOrTheBoundary)
{
  for (const Surface& surface : { Meshes::Icosphere(4), Meshes::Torus(64, 32), Meshes::Potato(4) })
  {
    for (const int degree : { 1, 2 })
    {
      const StripePattern pattern = SmoothPattern(surface, degree, Spaced(0.12));
      std::vector<int> ends(pattern.Singularities.size(), 0);
      for (std::size_t i = 0; i < pattern.Closed.size(); ++i)
      {
        for (const Index end : pattern.EndSingularities[i])
        {
          EXPECT_EQ(end == None, pattern.Closed[i] != 0);
          if (end != None)
          {
            ++ends[end];
          }
        }
      }
      for (std::size_t k = 0; k < ends.size(); ++k)
      {
        const StripeSingularity& singularity = pattern.Singularities[k];
        if (degree == 2 && singularity.FieldIndex % 2 != 0)
        {
          // Lines turn around an odd singularity or end in it: one at +1/2, three at -1/2.
          EXPECT_TRUE(ends[k] == 0 || ends[k] == 1 || ends[k] == 3) << ends[k];
        }
        else
        {
          EXPECT_EQ(ends[k], std::abs(singularity.StripeIndex));
          EXPECT_GT(ends[k], 0);
        }
      }
    }
  }
}

TEST(Stripes, OfALineFieldAreThoseOfTheVectorFieldThatItIs)
{
  const Surface torus = Meshes::Torus(64, 32);
  const StripeOptions options = Spaced(0.15, StripeDirection::Across);
  const StripePattern vectors = PatternOf(torus, East(torus), options);
  const StripePattern lines = PatternOf(torus, AsLineField(East(torus)), options);
  EXPECT_GT(vectors.BranchPoints, 10);
  // Rounding, which differs with the signs, may lead a branch point to the triangle beside.
  EXPECT_NEAR(lines.Misfit, vectors.Misfit, 5e-3 * vectors.Misfit);
  EXPECT_NEAR(lines.BranchPoints, vectors.BranchPoints, 2.0);
  EXPECT_NEAR(LengthOf(lines), LengthOf(vectors), 5e-3 * LengthOf(vectors));
}

TEST(Stripes, DoNotDependOnNumbersAndScale)
{
  const Surface surface = Meshes::Potato(4);
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  const Surface shuffled = Meshes::Shuffled(surface, 3, newPoint, newTriangle);
  Surface scaled = surface;
  for (Vector3& p : scaled.Points)
  {
    p *= 1e5;
  }
  for (const int degree : { 1, 2 })
  {
    const Result result = Fields::Compute(surface, degree);
    const PointDirections directions = Fields::Of(result);
    std::vector<Index> oldPoint(newPoint.size());
    for (std::size_t i = 0; i < newPoint.size(); ++i)
    {
      oldPoint[newPoint[i]] = static_cast<Index>(i);
    }
    PointDirections renumbered = directions;
    renumbered.Direction = [&](Index p, int k) { return directions.Direction(oldPoint[p], k); };
    renumbered.Magnitude = [&](Index p) { return directions.Magnitude(oldPoint[p]); };
    const StripePattern pattern = PatternOf(surface, directions, Spaced(0.2));
    for (const StripePattern& other : { PatternOf(shuffled, renumbered, Spaced(0.2)),
           PatternOf(scaled, directions, Spaced(0.2e5)) })
    {
      EXPECT_NEAR(other.Misfit, pattern.Misfit, 1e-3 * pattern.Misfit);
      EXPECT_EQ(other.BranchPoints, pattern.BranchPoints);
      EXPECT_EQ(other.Length.size(), pattern.Length.size());
    }
  }
}

TEST(Stripes, TurnWithTheSurface)
{
  const Surface surface = Meshes::Potato(4);
  const Surface turned =
    Meshes::Transformed(surface, Meshes::ObliqueRotation(1.0), Vector3(3.0, 1.0, 2.0));
  for (const int degree : { 1, 2 })
  {
    const Result result = Fields::Compute(surface, degree);
    PointDirections along = Fields::Of(result);
    const PointDirections before = along;
    along.Direction = [&](Index p, int k)
    { return Vector3(Meshes::ObliqueRotation(1.0) * before.Direction(p, k)); };
    const StripePattern pattern = PatternOf(surface, before, Spaced(0.2));
    const StripePattern other = PatternOf(turned, along, Spaced(0.2));
    EXPECT_NEAR(other.Misfit, pattern.Misfit, 0.03 * pattern.Misfit);
    EXPECT_NEAR(other.BranchPoints, pattern.BranchPoints, 0.1 * pattern.BranchPoints);
  }
}

TEST(Stripes, LinesAreAsLongAsTheirSpacingAsksFor)
{
  for (const Surface& surface : { Meshes::Icosphere(5), Meshes::Potato(5), Meshes::Torus(128, 64) })
  {
    for (const int degree : { 1, 2 })
    {
      const double spacing = 0.05;
      const StripePattern pattern = SmoothPattern(surface, degree, Spaced(spacing));
      EXPECT_NEAR(LengthOf(pattern) * spacing / AreaOf(surface), 1.0, 0.03);
    }
  }
}

TEST(Stripes, OffsetsMoveTheLinesByPartsOfTheSpacing)
{
  const Surface square = Meshes::Square(16);
  const PointDirections field = Fields::PlanarField(square, 1, [](const Vector3&) { return 0.0; });
  StripeOptions options = Spaced(0.25);
  const auto heights = [&](double offset)
  {
    options.LineOffset = offset;
    const StripePattern pattern = PatternOf(square, field, options);
    std::vector<double> result;
    for (std::size_t i = 0; i < pattern.Closed.size(); ++i)
    {
      const double height = pattern.LinePositions[pattern.LineOffsets[i]].y() / 0.25;
      result.push_back(height - std::floor(height));
    }
    return result;
  };
  const double first = heights(0.0).front();
  for (const double offset : { 0.0, 0.2, 0.5, -0.3 })
  {
    for (const double height : heights(offset))
    {
      EXPECT_NEAR(std::remainder(height - first - offset, 1.0), 0.0, 1e-2);
    }
  }
  // The sense of line fields is open.
  options.LineOffset = 0.4;
  EXPECT_EQ(
    PatternOf(square, Fields::PlanarField(square, 2, [](const Vector3&) { return 0.0; }), options)
      .LineOffset,
    0.5);
}

TEST(Stripes, SpacingsOfPointsHoldWhereTheyAre)
{
  const Surface square = Meshes::Square(40);
  const GivenField field(
    square, Fields::PlanarField(square, 1, [](const Vector3&) { return 0.0; }));
  // Half as far from each other to the right, and none at all to the left.
  const auto spacing = [&](Index p)
  {
    const double x = square.Points[p].x();
    return x < 0.31 ? (x < 0.2 ? -1.0 : std::numeric_limits<double>::quiet_NaN())
                    : (x < 0.64 ? 0.1 : 0.05);
  };
  const StripePattern pattern = MakeStripes(field, {}, spacing);
  const auto lengthBetween = [&](double left, double right)
  {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < pattern.LineOffsets.size(); ++i)
    {
      for (std::int64_t p = pattern.LineOffsets[i] + 1; p < pattern.LineOffsets[i + 1]; ++p)
      {
        const Vector3 middle = 0.5 * (pattern.LinePositions[p] + pattern.LinePositions[p - 1]);
        length += middle.x() > left && middle.x() < right
          ? (pattern.LinePositions[p] - pattern.LinePositions[p - 1]).norm()
          : 0.0;
      }
    }
    return length;
  };
  EXPECT_EQ(lengthBetween(0.0, 0.2), 0.0);
  EXPECT_NEAR(lengthBetween(0.4, 0.6), 0.2 / 0.1, 0.2);
  EXPECT_NEAR(lengthBetween(0.7, 1.0), 0.3 / 0.05, 0.3);
  EXPECT_EQ(pattern.Spacing, 0.0);
}

TEST(Stripes, GoOnOverSurfacesThatCannotBeOriented)
{
  const Surface strip = Meshes::MoebiusStrip(160, 10);
  for (const int degree : { 1, 2 })
  {
    const Result result = Fields::Compute(strip, degree);
    const StripePattern along = PatternOf(strip, Fields::Of(result), Spaced(0.1));
    const StripePattern across =
      PatternOf(strip, Fields::Of(result), Spaced(0.1, StripeDirection::Across));
    EXPECT_NEAR(LengthOf(along) * 0.1 / AreaOf(strip), 1.0, 0.02);
    EXPECT_NEAR(LengthOf(across) * 0.1 / AreaOf(strip), 1.0, 0.02);
    EXPECT_EQ(along.BranchPoints + across.BranchPoints, 0);
  }
}

TEST(Stripes, HaveTheSameBytesForAnyNumberOfThreads)
{
  const Surface surface = Meshes::Potato(5);
  for (const int degree : { 1, 2 })
  {
    const Result result = Fields::Compute(surface, degree);
    const auto pattern = [&](int number)
    {
      Threads threads(number);
      const Threads::Scope scope(threads);
      return PatternOf(surface, Fields::Of(result), Spaced(0.15));
    };
    const StripePattern one = pattern(1);
    const StripePattern three = pattern(3);
    EXPECT_EQ(one.LinePositions, three.LinePositions);
    EXPECT_EQ(one.LineOffsets, three.LineOffsets);
    EXPECT_EQ(one.BandPositions, three.BandPositions);
    EXPECT_EQ(one.BandCorners, three.BandCorners);
    EXPECT_EQ(one.Misfit, three.Misfit);
  }
}

TEST(Stripes, LeaveGhostsOut)
{
  Surface square = Meshes::Square(16);
  square.Ghost.assign(square.Triangles.size(), 0);
  for (std::size_t t = 0; t < square.Triangles.size(); ++t)
  {
    square.Ghost[t] = square.Points[square.Triangles[t][0]].x() >= 0.5 ? 1 : 0;
  }
  const StripePattern pattern = PatternOf(
    square, Fields::PlanarField(square, 1, [](const Vector3&) { return 0.0; }), Spaced(0.1));
  for (const Vector3& p : pattern.LinePositions)
  {
    EXPECT_LT(p.x(), 0.6);
  }
  for (const Index t : pattern.BandTriangle)
  {
    EXPECT_EQ(square.Ghost[t], 0);
  }
}

TEST(Stripes, SayWhatTheyCannotDo)
{
  const Surface square = Meshes::Square(4);
  const auto straight = [](const Vector3&) { return 0.0; };
  EXPECT_THROW(PatternOf(square, Fields::PlanarField(square, 4, straight), Spaced(0.1)),
    std::invalid_argument);
  const PointDirections field = Fields::PlanarField(square, 1, straight);
  EXPECT_THROW(PatternOf(square, field, Spaced(-1.0)), std::invalid_argument);
  EXPECT_THROW(PatternOf(square, field, Spaced(1e-12)), std::invalid_argument);
  EXPECT_THROW(PatternOf(square, field, Spaced(1e-320)), std::invalid_argument);
  StripeOptions options;
  options.LineOffset = 2.0;
  EXPECT_THROW(PatternOf(square, field, options), std::invalid_argument);
  const GivenField given(square, field);
  const StripePattern stopped = MakeStripes(given, {}, {}, [](double) { return false; });
  EXPECT_TRUE(stopped.Aborted);
  EXPECT_TRUE(stopped.LinePoints.empty());
  // Nothing is a pattern without lines.
  EXPECT_EQ(PatternOf(Surface(), field, {}).Length.size(), 0u);
}
