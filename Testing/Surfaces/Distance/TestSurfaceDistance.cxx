// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SurfaceDistance.h"
#include "Geometry/SurfaceGeometry.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// The triangle and weights that are nearest to a place in the plane z = 0.
MeshPlace PlaceIn(const SurfaceGeometry& geometry, double x, double y)
{
  MeshPlace best;
  double least = -1e300;
  for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); ++t)
  {
    std::array<Vector3, 3> p;
    for (int c = 0; c < 3; ++c)
    {
      p[static_cast<std::size_t>(c)] =
        geometry.Positions[static_cast<std::size_t>(geometry.Mesh.Tail(3 * t + c))];
    }
    const Vector3 q(x, y, 0.0);
    const double area = (p[1] - p[0]).cross(p[2] - p[0]).z();
    const std::array<double, 3> w = { (p[1] - q).cross(p[2] - q).z() / area,
      (p[2] - q).cross(p[0] - q).z() / area, (p[0] - q).cross(p[1] - q).z() / area };
    const double inside = std::min({ w[0], w[1], w[2] });
    if (inside > least)
    {
      least = inside;
      best = { t, w };
    }
  }
  return best;
}
}

TEST(SurfaceDistance, IsExactInThePlane)
{
  const SurfaceGeometry geometry(Disk(12));
  const MeshPlace source = PlaceIn(geometry, 0.23, -0.11);
  std::vector<SurfaceDistance::Seed> seeds;
  SurfaceDistance::AddSeeds(geometry, source, 5, seeds);
  const SurfaceDistance distance(geometry, seeds);
  const double unit = geometry.Lengths.Unit[0];
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const auto at = static_cast<std::size_t>(v);
    const double expected = (geometry.Positions[at] - Vector3(0.23, -0.11, 0.0)).norm();
    EXPECT_NEAR(distance.Distance[at] * unit, expected, 2e-3);
    EXPECT_EQ(distance.Source[at], 5);
  }
  EXPECT_EQ(distance.Order.size(), static_cast<std::size_t>(geometry.Mesh.GetNumberOfVertices()));
  Index nearest = None;
  EXPECT_NEAR(distance.At(geometry, PlaceIn(geometry, -0.4, 0.3), nearest) * unit,
    std::hypot(0.63, 0.41), 2e-3);
  EXPECT_EQ(nearest, 5);
}

TEST(SurfaceDistance, IsTheAngleOnASphere)
{
  double before = 0.0;
  for (const int levels : { 3, 4, 5 })
  {
    const SurfaceGeometry geometry(Icosphere(levels));
    const SurfaceDistance distance(geometry, { { 0, 0.0, 0 } });
    double worst = 0.0;
    for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
    {
      const auto at = static_cast<std::size_t>(v);
      const double expected =
        std::acos(std::clamp(geometry.Positions[at].dot(geometry.Positions[0]), -1.0, 1.0));
      worst =
        std::max(worst, std::abs(distance.Distance[at] * geometry.Lengths.Unit[0] - expected));
    }
    EXPECT_LT(worst, before > 0.0 ? 0.7 * before : 0.07) << levels;
    before = worst;
  }
}

TEST(SurfaceDistance, FrontsEndWhereTheyAreToldAndMeetBetweenTheirSources)
{
  const SurfaceGeometry geometry(Square(20));
  const double unit = geometry.Lengths.Unit[0];
  std::vector<SurfaceDistance::Seed> seeds;
  SurfaceDistance::AddSeeds(geometry, PlaceIn(geometry, 0.21, 0.51), 0, seeds);
  SurfaceDistance::AddSeeds(geometry, PlaceIn(geometry, 0.79, 0.51), 1, seeds);
  const SurfaceDistance distance(geometry, seeds, 0.25 / unit);
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const auto at = static_cast<std::size_t>(v);
    const Vector3& p = geometry.Positions[at];
    const double first = std::hypot(p.x() - 0.21, p.y() - 0.51);
    const double second = std::hypot(p.x() - 0.79, p.y() - 0.51);
    if (std::min(first, second) < 0.24)
    {
      EXPECT_NEAR(distance.Distance[at] * unit, std::min(first, second), 5e-3);
      if (std::abs(first - second) > 0.02)
      {
        EXPECT_EQ(distance.Source[at], first < second ? 0 : 1);
      }
    }
    if (std::min(first, second) > 0.252)
    {
      EXPECT_EQ(distance.Source[at], None);
      EXPECT_TRUE(std::isinf(distance.Distance[at]));
    }
  }
}

TEST(SurfaceDistance, DoesNotLeaveAComponent)
{
  const SurfaceGeometry geometry(Joined(Icosphere(2), Square(3)));
  const SurfaceDistance distance(geometry, { { 0, 0.0, 0 } });
  EXPECT_EQ(
    distance.Order.size(), static_cast<std::size_t>(geometry.Mesh.GetComponents()[0].Vertices()));
}
