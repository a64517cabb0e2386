// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Distance/ClosestPoints.h"
#include "Guidance/CurveGuidance.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
using Curves = std::vector<std::vector<Vector3>>;

/// The angle in degrees between a vector and the nearest of n directions, one of which is given.
double AngleTo(const Vector3& vector, const Vector3& direction, const Vector3& normal, int degree)
{
  const double angle =
    std::atan2(normal.dot(direction.cross(vector)), direction.dot(vector)) * 180.0 / Pi;
  return std::abs(std::remainder(angle, 360.0 / degree));
}

/// The distance of a place from a segment in the plane.
double ToSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const double s = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - s * (b - a)).norm();
}

std::vector<Vector3> GreatCircle(const Vector3& x, const Vector3& y, int parts)
{
  std::vector<Vector3> circle;
  for (int i = 0; i <= parts; ++i)
  {
    const double angle = 2.0 * Pi * i / parts;
    circle.emplace_back(std::cos(angle) * x + std::sin(angle) * y);
  }
  return circle;
}
}

TEST(CurveGuidance, CornersOfCrossedTrianglesPointAlongTheCurve)
{
  const Surface surface = Jittered(Disk(12), 0.0, 1);
  const Vector3 from(-0.53, -0.21, 0.0);
  const Vector3 to(0.61, 0.33, 0.0);
  for (const int degree : { 1, 2, 3, 4, 6 })
  {
    const CurveGuidance guidance = GuideByCurves(surface, { { from, to } }, { degree });
    Index guided = 0;
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      const double distance = ToSegment(surface.Points[i], from, to);
      if (guidance.Weights[i] > 0.0)
      {
        ++guided;
        EXPECT_NEAR(guidance.Weights[i], 1.0, 1e-12);
        EXPECT_NEAR(guidance.Vectors[i].norm(), 1.0, 1e-12);
        EXPECT_LT(AngleTo(guidance.Vectors[i], to - from, Vector3::UnitZ(), degree), 1e-9);
        EXPECT_LT(distance, 0.1);
      }
      else
      {
        EXPECT_TRUE(guidance.Vectors[i].isZero(0.0));
        EXPECT_GT(distance, 0.001);
      }
    }
    EXPECT_GT(guided, 20);
  }
}

TEST(CurveGuidance, CrossingCurvesAgreeOrCancelAsTheDegreeSays)
{
  const Surface surface = Square(20);
  const Curves cross = { { { 0.1, 0.51, 0.0 }, { 0.9, 0.51, 0.0 } },
    { { 0.51, 0.1, 0.0 }, { 0.51, 0.9, 0.0 } } };
  const auto weightAt = [&](int degree, double x, double y)
  {
    const CurveGuidance guidance = GuideByCurves(surface, cross, { degree });
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      const Vector3 p(x, y, 0.0);
      nearest = (surface.Points[i] - p).norm() < (surface.Points[nearest] - p).norm() ? i : nearest;
    }
    return guidance.Weights[nearest];
  };
  EXPECT_NEAR(weightAt(4, 0.5, 0.5), 1.0, 1e-9);
  EXPECT_LT(weightAt(2, 0.5, 0.5), 0.3);
  EXPECT_NEAR(weightAt(2, 0.2, 0.5), 1.0, 1e-9);
  EXPECT_NEAR(weightAt(4, 0.2, 0.5), 1.0, 1e-9);
}

TEST(CurveGuidance, OppositeSensesAgreeForEvenDegrees)
{
  const Surface surface = Disk(10);
  const Vector3 from(-0.5, 0.12, 0.0);
  const Vector3 to(0.5, 0.12, 0.0);
  for (const int degree : { 1, 2, 3, 4 })
  {
    const CurveGuidance guidance =
      GuideByCurves(surface, { { from, to }, { to, from } }, { degree });
    const double most = *std::max_element(guidance.Weights.begin(), guidance.Weights.end());
    if (degree % 2 == 0)
    {
      EXPECT_NEAR(most, 1.0, 1e-12);
    }
    else
    {
      EXPECT_EQ(most, 0.0);
    }
  }
}

TEST(CurveGuidance, WeightsFallAsAGaussianOfTheDistance)
{
  const Surface surface = Disk(30);
  const Vector3 from(-2.0, 0.013, 0.0);
  const Vector3 to(2.0, 0.013, 0.0);
  CurveGuidanceOptions options{ 2, 0.3, 0.5 };
  const CurveGuidance guidance = GuideByCurves(surface, { { from, to } }, options);
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const double distance = std::abs(surface.Points[i].y() - 0.013);
    if (surface.Points[i].norm() > 0.8)
    {
      // Samples beyond the rim of the disk are laid onto the rim.
      continue;
    }
    if (distance < 0.29)
    {
      EXPECT_NEAR(guidance.Weights[i], std::exp(-0.5 * std::pow(distance / 0.15, 2)), 0.02);
      EXPECT_LT(AngleTo(guidance.Vectors[i], to - from, Vector3::UnitZ(), 2), 1.0);
    }
    if (distance > 0.31)
    {
      EXPECT_EQ(guidance.Weights[i], 0.0);
    }
  }
}

TEST(CurveGuidance, AGreatCircleGuidesAlongItself)
{
  const Surface surface = Icosphere(4);
  const Eigen::Matrix3d rotation = ObliqueRotation(0.7);
  const std::vector<Vector3> circle = GreatCircle(rotation.col(0), rotation.col(1), 500);
  for (const double radius : { 0.0, 0.4 })
  {
    const CurveGuidance guidance = GuideByCurves(surface, { circle }, { 4, radius });
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      if (guidance.Weights[i] > 0.0)
      {
        // The tangents are carried to parallel circles, up to the turn of the sphere.
        const Vector3& p = surface.Points[i];
        const Vector3 along = rotation.col(2).cross(p).normalized();
        EXPECT_LT(AngleTo(guidance.Vectors[i], along, p, 4), radius > 0.0 ? 3.0 : 1.5);
        EXPECT_LT(std::abs(std::asin(p.dot(rotation.col(2)))), std::max(radius, 0.1) + 0.02);
      }
    }
  }
}

TEST(CurveGuidance, DoesNotDependOnPositionAndNumbers)
{
  const Surface surface = Potato(3);
  const Curves curves = { GreatCircle(Vector3(0.9, 0.0, 0.2), Vector3(0.0, 0.9, 0.1), 100) };
  const CurveGuidanceOptions options{ 4, 0.3 };
  const CurveGuidance guidance = GuideByCurves(surface, curves, options);
  const Eigen::Matrix3d rotation = ObliqueRotation(1.1);
  const Vector3 shift(3.0, -2.0, 1.0);
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  const Surface moved =
    Shuffled(Transformed(surface, 10.0 * rotation, shift), 5, newPoint, newTriangle);
  Curves movedCurves = curves;
  for (Vector3& p : movedCurves[0])
  {
    p = Vector3(10.0 * rotation * p + shift);
  }
  CurveGuidanceOptions larger = options;
  larger.Radius *= 10.0;
  const CurveGuidance other = GuideByCurves(moved, movedCurves, larger);
  int different = 0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const auto j = static_cast<std::size_t>(newPoint[i]);
    if (std::abs(guidance.Weights[i] - other.Weights[j]) > 1e-6)
    {
      ++different;
    }
    else if (guidance.Weights[i] > 0.0)
    {
      const Vector3 turned = rotation * guidance.Vectors[i];
      const Vector3 normal = turned.cross(other.Vectors[j]).norm() > 1e-9
        ? Vector3(turned.cross(other.Vectors[j]).normalized())
        : Vector3::UnitZ();
      EXPECT_LT(AngleTo(other.Vectors[j], turned, normal, 4), 1e-4);
    }
  }
  // Samples that are equally near to two triangles may change sides.
  EXPECT_LE(different, 2);
}

TEST(CurveGuidance, FieldsFollowTheCurve)
{
  const Surface surface = Icosphere(4);
  const Eigen::Matrix3d rotation = ObliqueRotation(0.4);
  const CurveGuidance strokes =
    GuideByCurves(surface, { GreatCircle(rotation.col(0), rotation.col(1), 300) }, { 4 });
  Guidance guidance;
  guidance.Vectors = strokes.Vectors;
  guidance.Weights = strokes.Weights;
  Options options;
  options.ConstrainGuidance = true;
  options.DropConstraintsAtSingularities = false;
  const Result field = DirectionFields::DirectionField(surface).Compute(options, guidance);
  Index constrained = 0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    if (strokes.Weights[i] > 0.0)
    {
      ++constrained;
      EXPECT_LT(Deviation(field, static_cast<Index>(i), strokes.Vectors[i]), 1e-4);
    }
  }
  EXPECT_EQ(Count(field, ConstraintKind::Given), constrained);
  EXPECT_GT(constrained, 60);
}

TEST(CurveGuidance, WhatIsNoCurveGuidesNothing)
{
  const Surface surface = Potato(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Curves nothing = { {}, { Vector3::Zero() }, { { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } },
    { { nan, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } };
  const CurveGuidance guidance = GuideByCurves(surface, nothing, {});
  EXPECT_EQ(guidance.Samples, 0);
  EXPECT_EQ(*std::max_element(guidance.Weights.begin(), guidance.Weights.end()), 0.0);
  // A curve that is far away, where that is not allowed.
  const Curves far = { { { 50.0, 0.0, 0.0 }, { 50.0, 1.0, 0.0 } } };
  EXPECT_GT(GuideByCurves(surface, far, { 4, 0.0, 0.5, 10.0 }).FarSamples, 0);
  EXPECT_EQ(GuideByCurves(surface, far, {}).FarSamples, 0);
  EXPECT_TRUE(GuideByCurves(Surface(), far, {}).Weights.empty());
  EXPECT_THROW(GuideByCurves(surface, far, { 0 }), std::invalid_argument);
  EXPECT_THROW(GuideByCurves(surface, far, { 4, -1.0 }), std::invalid_argument);
  EXPECT_THROW(GuideByCurves(surface, far, { 4, 1.0, 0.0 }), std::invalid_argument);
}

// A point far out of place, as in a broken file, once made two million samples of a curve beside twenty triangles.
TEST(CurveGuidance, SegmentsBeyondTheSurfaceCostNoMoreThanItsTriangles)
{
  const Surface small = Octahedron();
  const Curves far = { { Vector3(-1e9, 0.1, 1.0), Vector3(1e9, 0.1, 1.0) } };
  EXPECT_LE(GuideByCurves(small, far, { 4 }).Samples, 10000);
  // Along a strip of long and short triangles, whose box is as long as it can be, none is left out.
  const Surface strip = Cylinder(3, 30000, 30000.0);
  double edges = 0.0;
  for (const Triangle& t : strip.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      edges += (strip.Points[t[c]] - strip.Points[t[(c + 1) % 3]]).norm();
    }
  }
  const Vector3 low = strip.Points.front();
  Vector3 high = low;
  for (const Vector3& p : strip.Points)
  {
    high = (p - low).norm() > (high - low).norm() ? p : high;
  }
  const double mean = edges / (3.0 * strip.Triangles.size());
  const Index samples = GuideByCurves(strip, { { low, high } }, { 4 }).Samples;
  EXPECT_GT(samples, 20000);
  EXPECT_NEAR(samples, 2.0 * (high - low).norm() / mean, 0.01 * samples);
}

TEST(CurveGuidance, OfCurvesThatChangeIsThatOfEachAlone)
{
  const auto surface = std::make_shared<const Surface>(Potato(3));
  SurfaceCurves kept(surface);
  const Curves one = { GreatCircle(Vector3::UnitX(), Vector3::UnitY(), 40) };
  const Curves two = { one[0], GreatCircle(Vector3::UnitX(), Vector3::UnitZ(), 30) };
  for (const auto& [curves, options] : std::vector<std::pair<Curves, CurveGuidanceOptions>>{
         { one, { 4 } }, { two, { 4, 0.3 } }, { one, { 2, 0.3 } }, { {}, { 2 } }, { two, { 4 } } })
  {
    const CurveGuidance again = kept.Guide(curves, options);
    const CurveGuidance alone = GuideByCurves(*surface, curves, options);
    EXPECT_EQ(again.Vectors, alone.Vectors);
    EXPECT_EQ(again.Weights, alone.Weights);
    EXPECT_EQ(again.Samples, alone.Samples);
    EXPECT_EQ(again.FarSamples, alone.FarSamples);
  }
  EXPECT_THROW(kept.Guide(one, { 0 }), std::invalid_argument);
  EXPECT_EQ(kept.Guide(one, { 4 }).Weights, GuideByCurves(*surface, one, { 4 }).Weights);
}

TEST(CurveGuidance, BothSidesOfAStripAgree)
{
  const Surface strip = MoebiusStrip(40, 4);
  std::vector<Vector3> middle;
  for (int i = 0; i <= 200; ++i)
  {
    const double angle = 2.0 * Pi * i / 200.0;
    middle.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  const CurveGuidance guidance = GuideByCurves(strip, { middle }, { 2 });
  const double most = *std::max_element(guidance.Weights.begin(), guidance.Weights.end());
  EXPECT_GT(most, 0.99);
}

TEST(ClosestPoints, OfASurfaceAreThoseOfAllTriangles)
{
  const Surface surface = Potato(2);
  const ClosestPoints tree(surface);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 p(std::sin(1.3 * i), 1.4 * std::cos(2.1 * i), std::sin(0.7 * i + 1.0));
    const ClosestPoints::Answer found = tree.Find(p);
    ASSERT_NE(found.Triangle, None);
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : surface.Triangles)
    {
      // Many points of each triangle.
      for (int a = 0; a <= 12; ++a)
      {
        for (int b = 0; a + b <= 12; ++b)
        {
          const Vector3 q = (a * surface.Points[triangle[0]] + b * surface.Points[triangle[1]] +
                              (12 - a - b) * surface.Points[triangle[2]]) /
            12.0;
          least = std::min(least, (p - q).norm());
        }
      }
    }
    const double distance = std::sqrt(found.SquaredDistance);
    EXPECT_LE(distance, least + 1e-12);
    EXPECT_GT(distance, least - 0.03);
    EXPECT_NEAR(found.Weights[0] + found.Weights[1] + found.Weights[2], 1.0, 1e-12);
    EXPECT_EQ(tree.Find(p, Vector3::Zero(), 0.5 * distance).Triangle,
      distance > 0.0 ? None : found.Triangle);
  }
}
