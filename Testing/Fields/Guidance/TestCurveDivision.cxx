// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/CurveDivision.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
using Curve = std::vector<Vector3>;
using Curves = std::vector<Curve>;

/// What of curves runs on each of some surfaces.
std::vector<Curves> Divide(const std::vector<Surface>& surfaces, const Curves& curves)
{
  std::vector<std::unique_ptr<SurfaceCurves>> kept;
  std::vector<SurfaceCurves*> pointers;
  for (const Surface& surface : surfaces)
  {
    kept.push_back(std::make_unique<SurfaceCurves>(std::make_shared<const Surface>(surface)));
    pointers.push_back(kept.back().get());
  }
  return DivideCurves(pointers, curves);
}

Surface Moved(const Surface& surface, double factor, const Vector3& shift)
{
  return Transformed(surface, factor * Eigen::Matrix3d::Identity(), shift);
}

/// A unit square in the plane, from x0 to x0 + 1.
Surface Sheet(double x0, int cells)
{
  return Moved(Square(cells), 1.0, Vector3(x0, 0.0, 0.0));
}

double Length(const Curve& curve)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    const double segment = (curve[i + 1] - curve[i]).norm();
    length += std::isfinite(segment) ? segment : 0.0;
  }
  return length;
}

bool IsGuided(const Surface& surface, const Curves& curves)
{
  const CurveGuidance guidance = GuideByCurves(surface, curves, {});
  return std::any_of(
    guidance.Weights.begin(), guidance.Weights.end(), [](double weight) { return weight > 0.0; });
}

Curve Parallel(double height, const Vector3& shift)
{
  Curve circle;
  for (int i = 0; i <= 30; ++i)
  {
    const double angle = 2.0 * Pi * i / 60;
    circle.emplace_back(shift +
      Vector3(std::sqrt(1.0 - height * height) * std::cos(angle),
        std::sqrt(1.0 - height * height) * std::sin(angle), height));
  }
  return circle;
}
}

TEST(CurveDivision, CurvesOnOneOfTwoSpheresGuideThatOneAlone)
{
  const Vector3 aside(2.5, 0.0, 0.0);
  const std::vector<Surface> spheres = { Icosphere(3), Moved(Icosphere(3), 1.0, aside) };
  const Curve first = Parallel(0.1, Vector3::Zero());
  const Curve second = Parallel(-0.3, aside);
  const std::vector<Curves> divided = Divide(spheres, { first, second });
  ASSERT_EQ(divided.size(), 2U);
  EXPECT_EQ(divided[0], (Curves{ first, {} }));
  EXPECT_EQ(divided[1], (Curves{ {}, second }));
  EXPECT_TRUE(IsGuided(spheres[0], divided[0]));
  EXPECT_FALSE(IsGuided(spheres[1], { divided[1][0] }));
  // Whatever the order.
  const std::vector<Curves> turned = Divide({ spheres[1], spheres[0] }, { first, second });
  EXPECT_EQ(turned[0], divided[1]);
  EXPECT_EQ(turned[1], divided[0]);
}

TEST(CurveDivision, CurveOverASeamIsCutAtIt)
{
  const int squares = 10;
  const std::vector<Surface> sheets = { Sheet(0.0, squares), Sheet(1.0, squares) };
  const Curve curve = { { 0.23, 0.31, 0.0 }, { 0.71, 0.34, 0.0 }, { 1.62, 0.77, 0.0 } };
  const std::vector<Curves> divided = Divide(sheets, { curve });
  const Curve& left = divided[0][0];
  const Curve& right = divided[1][0];
  ASSERT_EQ(left.size(), 3U);
  ASSERT_EQ(right.size(), 2U);
  EXPECT_EQ(left[0], curve[0]);
  EXPECT_EQ(left[1], curve[1]);
  EXPECT_EQ(left[2], right[0]);
  EXPECT_EQ(right[1], curve[2]);
  EXPECT_NEAR(Length(left) + Length(right), Length(curve), 1e-14);
  // The pieces are no longer than half an edge, and what is a tenth of one away is as near.
  EXPECT_NEAR(right[0].x(), 1.0, 0.6 / squares);
}

TEST(CurveDivision, CurveThatComesBackIsInPieces)
{
  const std::vector<Surface> sheets = { Sheet(0.0, 10), Sheet(1.0, 10) };
  const Curve curve = { { 0.5, 0.2, 0.0 }, { 1.5, 0.2, 0.0 }, { 1.5, 0.8, 0.0 },
    { 0.5, 0.8, 0.0 } };
  const std::vector<Curves> divided = Divide(sheets, { curve });
  const auto breaks = std::count_if(divided[0][0].begin(), divided[0][0].end(),
    [](const Vector3& place) { return !place.allFinite(); });
  EXPECT_EQ(breaks, 1);
  EXPECT_NEAR(Length(divided[0][0]) + Length(divided[1][0]), Length(curve), 1e-14);
}

TEST(CurveDivision, WhatIsAsNearToSeveralGoesToOne)
{
  const std::vector<Surface> sheets = { Sheet(0.0, 10), Sheet(1.0, 10) };
  // Along the seam, a little to either side of it in turn.
  Curve seam;
  for (int i = 0; i <= 40; ++i)
  {
    seam.emplace_back(1.0 + (i % 2 == 0 ? 1e-9 : -1e-9), 0.1 + 0.02 * i, 0.0);
  }
  // It ends on the right side, which then has more of it.
  Curve toTheRight = seam;
  toTheRight.emplace_back(1.4, 0.9, 0.0);
  Curve toTheLeft = seam;
  toTheLeft.emplace_back(0.6, 0.9, 0.0);
  const std::vector<Curves> divided = Divide(sheets, { toTheRight, toTheLeft });
  EXPECT_EQ(divided[0], (Curves{ {}, toTheLeft }));
  EXPECT_EQ(divided[1], (Curves{ toTheRight, {} }));
  const std::vector<Curves> copies =
    Divide({ sheets[1], sheets[0], sheets[0] }, { { { 0.2, 0.3, 0.1 }, { 0.6, 0.4, -0.1 } } });
  EXPECT_TRUE(copies[0][0].empty());
  EXPECT_EQ(copies[1][0].size(), 2U);
  EXPECT_TRUE(copies[2][0].empty());
}

TEST(CurveDivision, SizesDoNotMatter)
{
  const std::vector<Surface> sheets = { Sheet(0.0, 10), Sheet(1.0, 10) };
  const Curve curve = { { 0.23, 0.31, 0.01 }, { 0.71, 0.34, 0.0 }, { 1.62, 0.77, 0.02 } };
  const std::vector<Curves> divided = Divide(sheets, { curve });
  for (const double factor : { std::ldexp(1.0, -530), std::ldexp(1.0, 530) })
  {
    Curve scaled = curve;
    for (Vector3& place : scaled)
    {
      place *= factor;
    }
    const std::vector<Curves> found = Divide(
      { Moved(sheets[0], factor, Vector3::Zero()), Moved(sheets[1], factor, Vector3::Zero()) },
      { scaled });
    for (std::size_t s = 0; s < 2; ++s)
    {
      ASSERT_EQ(found[s][0].size(), divided[s][0].size());
      for (std::size_t i = 0; i < found[s][0].size(); ++i)
      {
        EXPECT_EQ(found[s][0][i], factor * divided[s][0][i]);
      }
    }
  }
}

TEST(CurveDivision, SurfacesWithoutTrianglesAndBrokenCurvesAreNoProblem)
{
  const Vector3 nowhere = Vector3::Constant(std::nan(""));
  const Curve curve = { { 0.2, 0.3, 0.0 }, { 0.6, 0.4, 0.0 }, nowhere, { 0.7, 0.4, 0.0 },
    { 0.7, 0.4, 0.0 }, { 0.8, 0.1, 0.0 } };
  const std::vector<Curves> divided = Divide({ Surface(), Sheet(0.0, 10) }, { curve, {} });
  EXPECT_EQ(divided[0], (Curves{ {}, {} }));
  ASSERT_EQ(divided[1][0].size(), 5U);
  EXPECT_EQ(divided[1][0][1], curve[1]);
  EXPECT_FALSE(divided[1][0][2].allFinite());
  EXPECT_EQ(divided[1][0][4], curve[5]);
  EXPECT_EQ(Divide({ Surface(), Surface() }, { curve }), (std::vector<Curves>{ { {} }, { {} } }));
  EXPECT_TRUE(Divide({}, { curve }).empty());
}
