// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths along the surface, and the shapes drawn there.

#include "Glyphs.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Paths/SurfacePath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>

using namespace DirectionFields;
using namespace Fields;

namespace
{
/// Squares left and right of the y axis, the right one turned upwards about it by an angle.
Surface Fold(double angle)
{
  Surface surface;
  for (const double y : { -1.0, 1.0 })
  {
    surface.Points.push_back({ -1.0, y, 0.0 });
    surface.Points.push_back({ 0.0, y, 0.0 });
    surface.Points.push_back({ std::cos(angle), y, std::sin(angle) });
  }
  surface.Triangles = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 } };
  return surface;
}

double Height(const SurfaceIncidence& surface, const Vector3& place)
{
  double height = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < surface.GetNumberOfTriangles(); ++t)
  {
    const Vector3 normal = surface.Normal(t);
    const double above = (place - surface.Corner(t, 0)).dot(normal);
    const Vector3 foot = place - above * normal;
    bool inside = true;
    for (int c = 0; c < 3; ++c)
    {
      const Vector3 edge = surface.Corner(t, (c + 1) % 3) - surface.Corner(t, c);
      inside = inside && edge.cross(foot - surface.Corner(t, c)).dot(normal) > -1e-9;
    }
    height = inside && std::abs(above) < std::abs(height) ? above : height;
  }
  return height;
}
}

TEST(SurfacePath, UnfoldsTheSurface)
{
  for (const double angle : { 0.0, 0.7, -0.7, 2.0, -2.0 })
  {
    const Surface surface = Fold(angle);
    const SurfaceIncidence incidence(surface);
    PathStart start;
    start.Position = { -0.5, 0.2, 0.0 };
    start.Normal = Vector3::UnitZ();
    start.Triangle = 0;
    if (Height(incidence, start.Position) != 0.0)
    {
      FAIL();
    }
    // Find the triangle that the place is in: of the two on the left, the upper one.
    start.Triangle = 1;
    const Vector3 direction = Vector3(2.0, 0.4, 0.0).normalized();
    const SurfacePath path = TracePath(incidence, start, direction, 1.0);
    const double x = -0.5 + direction.x();
    const Vector3 end(x * std::cos(angle), 0.2 + direction.y(), x * std::sin(angle));
    EXPECT_LT((path.Stations.back().Position - end).norm(), 1e-9) << angle;
    EXPECT_NEAR(path.Stations.back().Distance, 1.0, 1e-12);
    EXPECT_LT(
      (path.Stations.back().Normal - Vector3(-std::sin(angle), 0, std::cos(angle))).norm(), 1e-9);
    double length = 0.0;
    for (std::size_t i = 1; i < path.Stations.size(); ++i)
    {
      length += (path.Stations[i].Position - path.Stations[i - 1].Position).norm();
    }
    EXPECT_NEAR(length, 1.0, 1e-9);

    const SurfacePoint moved = Moved(incidence, { 1, { 0.5, 0.1, 0.4 } }, Vector3(0.9, 0.1, 5.0));
    const Vector3 from = SurfacePoint{ 1, { 0.5, 0.1, 0.4 } }.Position(incidence);
    const double movedX = from.x() + 0.9;
    EXPECT_LT((moved.Position(incidence) -
                Vector3(movedX > 0 ? movedX * std::cos(angle) : movedX, from.y() + 0.1,
                  movedX > 0 ? movedX * std::sin(angle) : 0.0))
                .norm(),
      1e-9);
  }
}

TEST(SurfacePath, StartsAtPointsAndLeavesAtTheBoundary)
{
  const Surface disk = Meshes::Disk(3);
  const SurfaceIncidence incidence(disk);
  PathStart start;
  start.Position = disk.Points[0];
  ASSERT_LT(start.Position.norm(), 1e-12);
  start.Normal = Vector3::UnitZ();
  start.Point = 0;
  for (int k = 0; k < 36; ++k)
  {
    const double angle = 0.1 + 2.0 * Pi * k / 36;
    const Vector3 direction(std::cos(angle), std::sin(angle), 0.0);
    const SurfacePath path = TracePath(incidence, start, direction, 1.7);
    EXPECT_LT((path.Stations.back().Position - 1.7 * direction).norm(), 1e-9);
    EXPECT_GT(path.Stations.size(), 3u);
    EXPECT_EQ(SimplifiedPath(path, 4).Stations.size(), 2u);
    // From the boundary outwards there is no triangle.
    PathStart outer = start;
    outer.Point = incidence.GetNumberOfPoints() - 1;
    outer.Position = disk.Points[outer.Point];
    const Vector3 away = outer.Position.normalized();
    EXPECT_LT((TracePath(incidence, outer, away, 0.5).Stations.back().Position - outer.Position -
                0.5 * away)
                .norm(),
      1e-9);
  }
  // Moved points stay on the surface.
  const SurfacePoint edge = Moved(incidence, { 0, { 0.3, 0.3, 0.4 } }, Vector3(30.0, 1.0, 0.0));
  EXPECT_NEAR(edge.Position(incidence).norm(), 1.0, 0.1);
  EXPECT_GT(edge.Position(incidence).x(), 0.8);
  // From a corner, too, and whichever triangle that leads into.
  const Index center = disk.Triangles[0][0];
  for (int k = 0; k < 12; ++k)
  {
    const Vector3 by(0.5 * std::cos(0.7 * k), 0.5 * std::sin(0.7 * k), 0.0);
    SurfacePoint corner{ 0, { 0, 0, 0 } };
    corner.Weights[incidence.FindCorner(0, center)] = 1.0;
    const Vector3 place = Moved(incidence, corner, by).Position(incidence);
    const double moved = (place - disk.Points[center]).norm();
    EXPECT_TRUE(moved == 0.0 || (place - disk.Points[center] - by).norm() < 1e-5) << moved;
  }
}

TEST(Glyphs, HaveOneArmForEachDirection)
{
  const Surface surface = Meshes::Potato(3);
  for (const int n : { 1, 2, 3, 4, 6, 9, 16 })
  {
    const Result result = Compute(surface, n);
    const PointDirections field = Of(result);
    for (const GlyphType type : { GlyphType::Automatic, GlyphType::Lines, GlyphType::Arrows,
           GlyphType::Ribbons, GlyphType::Tubes })
    {
      for (const GlyphMode mode : { GlyphMode::SpreadEvenly, GlyphMode::AllPoints })
      {
        GlyphOptions options;
        options.Type = type;
        options.Mode = mode;
        options.MaximumNumber = 150;
        const Glyphs glyphs = MakeGlyphs(surface, field, {}, {}, options);
        const GlyphMesh& mesh = glyphs.Mesh;
        const std::size_t count = glyphs.Point.size();
        EXPECT_LE(count, 150u);
        EXPECT_GE(count, 120u);
        EXPECT_EQ(mesh.AreLines, type == GlyphType::Lines);
        ASSERT_EQ(mesh.Offsets.size(), mesh.Glyph.size() + 1);
        ASSERT_EQ(mesh.Normals.size(), mesh.Points.size());
        std::vector<std::vector<int>> cells(count, std::vector<int>(n, 0));
        for (std::size_t i = 0; i < mesh.Glyph.size(); ++i)
        {
          ++cells[mesh.Glyph[i]][mesh.Branch[i]];
          EXPECT_GE(mesh.Offsets[i + 1] - mesh.Offsets[i], mesh.AreLines ? 2 : 3);
        }
        for (const auto& glyph : cells)
        {
          EXPECT_GE(*std::min_element(glyph.begin(), glyph.end()), 1);
        }
        for (std::size_t i = 0; i < mesh.Points.size(); ++i)
        {
          EXPECT_TRUE(mesh.Points[i].allFinite());
          EXPECT_NEAR(mesh.Normals[i].norm(), 1.0, 1e-9);
        }
        for (const std::int64_t id : mesh.Connectivity)
        {
          EXPECT_GE(id, 0);
          EXPECT_LT(id, static_cast<std::int64_t>(mesh.Points.size()));
        }
      }
    }
  }
}

TEST(Glyphs, AreFlatWhereTheyDoNotFollowTheSurface)
{
  const Surface surface = Meshes::Potato(2);
  const SurfaceIncidence incidence(surface);
  for (const int n : { 1, 4 })
  {
    const Result result = Compute(surface, n);
    const PointDirections field = Of(result);
    GlyphOptions options;
    options.Mode = GlyphMode::AllPoints;
    options.Scale = 0.8;
    options.Offset = 0.1;
    options.FollowSurface = false;
    const Glyphs glyphs = MakeGlyphs(surface, field, {}, {}, options);
    ASSERT_EQ(glyphs.Point.size(), surface.Points.size());
    std::vector<double> longest(glyphs.Point.size(), 0.0);
    std::vector<double> height(glyphs.Point.size(), -1.0);
    for (std::size_t i = 0; i < glyphs.Mesh.Glyph.size(); ++i)
    {
      const Index glyph = glyphs.Mesh.Glyph[i];
      const Index point = glyphs.Point[glyph];
      const double spacing = incidence.ShortestEdge(point);
      for (auto j = glyphs.Mesh.Offsets[i]; j < glyphs.Mesh.Offsets[i + 1]; ++j)
      {
        const Vector3 place =
          glyphs.Mesh.Points[glyphs.Mesh.Connectivity[j]] - surface.Points[point];
        const double above = place.dot(result.Normal[point]);
        if (height[glyph] < 0.0)
        {
          height[glyph] = above;
          EXPECT_GE(above, 0.1 * spacing - 1e-9);
        }
        EXPECT_NEAR(above, height[glyph], 1e-9);
        const Vector3 flat = place - above * result.Normal[point];
        longest[glyph] = std::max(longest[glyph], flat.norm());
        // The tip of an arm is not far from its direction.
        const double along = place.dot(result.Direction(point, glyphs.Mesh.Branch[i]));
        EXPECT_TRUE(n == 1 || flat.norm() < 0.39 * spacing || along > 0.98 * flat.norm());
      }
    }
    for (std::size_t g = 0; g < longest.size(); ++g)
    {
      EXPECT_NEAR(longest[g], 0.4 * incidence.ShortestEdge(glyphs.Point[g]), 1e-9);
    }
  }
}

TEST(Glyphs, DoNotDrownInTheSurface)
{
  // Coarse and sharp: a valley and a ridge of 90 degrees, and a chamfered cube.
  const Surface meshes[] = { Fold(0.5 * Pi), Fold(-0.5 * Pi), Meshes::ChamferedCube(2),
    Meshes::Potato(2) };
  for (const Surface& surface : meshes)
  {
    const SurfaceIncidence incidence(surface);
    for (const int n : { 1, 2, 4, 6 })
    {
      const Result result = Compute(surface, n);
      const PointDirections field = Of(result);
      for (const GlyphSide side : { GlyphSide::Front, GlyphSide::Back })
      {
        GlyphOptions options;
        options.MaximumNumber = 100;
        options.Side = side;
        const Glyphs glyphs = MakeGlyphs(surface, field, {}, {}, options);
        const double offset = options.Offset * glyphs.Spacing;
        const double up = side == GlyphSide::Front ? 1.0 : -1.0;
        int low = 0;
        for (const Vector3& place : glyphs.Mesh.Points)
        {
          low += up * Height(incidence, place) < 0.1 * offset ? 1 : 0;
        }
        // The width of an arm across a sharp valley is flat, and the back of a coarse round surface
        // is nothing but valleys.
        const double most = side == GlyphSide::Front ? 0.02 : 0.06;
        EXPECT_LE(low, most * static_cast<double>(glyphs.Mesh.Points.size()));
      }
    }
  }
}

TEST(Glyphs, FlatOnesAreRaisedInHollows)
{
  // The inside of a sphere.
  Surface surface = Meshes::Icosphere(4);
  for (Triangle& triangle : surface.Triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  const Result result = Compute(surface, 4);
  const PointDirections field = Of(result);
  GlyphOptions options;
  options.MaximumNumber = 60;
  options.FollowSurface = false;
  options.Side = GlyphSide::Front;
  const Glyphs glyphs = MakeGlyphs(surface, field, {}, {}, options);
  EXPECT_GT(glyphs.Point.size(), 40u);
  for (const Vector3& place : glyphs.Mesh.Points)
  {
    EXPECT_LT(place.norm(), 1.0);
  }
}

TEST(Glyphs, ArmsDoNotOverlap)
{
  // The area of a star is the sum of the areas of its arms if these overlap nowhere: count, for
  // many places, the polygons over them.
  const Surface surface = Meshes::Square(4);
  for (const int n : { 2, 3, 4, 6, 16 })
  {
    const PointDirections field =
      PlanarField(surface, n, [](const Vector3& p) { return 0.2 * p.x(); });
    for (const GlyphType type : { GlyphType::Ribbons, GlyphType::Arrows })
    {
      GlyphOptions options;
      options.Type = type;
      options.MaximumNumber = 30;
      const Glyphs glyphs = MakeGlyphs(surface, field, {}, {}, options);
      const GlyphMesh& mesh = glyphs.Mesh;
      int covered = 0;
      for (int i = 0; i < 10000; ++i)
      {
        const double x = (i % 100 + 0.512) / 100.0;
        const double y = (i / 100 + 0.487) / 100.0;
        int polygons = 0;
        for (std::size_t cell = 0; cell < mesh.Glyph.size(); ++cell)
        {
          bool inside = true;
          for (auto j = mesh.Offsets[cell]; j < mesh.Offsets[cell + 1] && inside; ++j)
          {
            const auto next = j + 1 < mesh.Offsets[cell + 1] ? j + 1 : mesh.Offsets[cell];
            const Vector3& a = mesh.Points[mesh.Connectivity[j]];
            const Vector3& b = mesh.Points[mesh.Connectivity[next]];
            // Counter-clockwise seen from above.
            inside = (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x()) > 0.0;
          }
          polygons += inside ? 1 : 0;
        }
        EXPECT_LE(polygons, 1) << n;
        covered += polygons;
      }
      EXPECT_GT(covered, 400);
    }
  }
}

TEST(Glyphs, HaveTheSizeOfTheSurfaceAtAnyScale)
{
  const Surface surface = Meshes::Potato(2);
  const Result result = Compute(surface, 4);
  const PointDirections field = Of(result);
  for (const GlyphMode mode : { GlyphMode::SpreadEvenly, GlyphMode::AllPoints })
  {
    GlyphOptions options;
    options.Mode = mode;
    options.MaximumNumber = 100;
    options.Spacing = mode == GlyphMode::AllPoints ? 0.0 : 0.5;
    const Glyphs usual = MakeGlyphs(surface, field, {}, {}, options);
    EXPECT_GT(usual.Point.size(), 20u);
    for (const int exponent : { -1000, -500, -333, -200, -160, 160, 200, 266, 333, 500, 1000 })
    {
      Surface scaled = surface;
      for (Vector3& point : scaled.Points)
      {
        point *= std::ldexp(1.0, exponent);
      }
      // The size of the surface is not that of points that no triangle uses.
      scaled.Points.emplace_back(1.0, 1e200, 0.0);
      scaled.Points.emplace_back(std::nan(""), 0.0, 0.0);
      options.Spacing = std::ldexp(mode == GlyphMode::AllPoints ? 0.0 : 0.5, exponent);
      const Glyphs glyphs = MakeGlyphs(scaled, field, {}, {}, options);
      EXPECT_EQ(glyphs.Point, usual.Point) << exponent;
      EXPECT_EQ(glyphs.Spacing, std::ldexp(usual.Spacing, exponent));
      ASSERT_EQ(glyphs.Mesh.Points.size(), usual.Mesh.Points.size());
      double difference = 0.0;
      for (std::size_t i = 0; i < usual.Mesh.Points.size(); ++i)
      {
        const Vector3 back = std::ldexp(1.0, -exponent) * glyphs.Mesh.Points[i];
        difference = std::max(difference, (back - usual.Mesh.Points[i]).norm());
      }
      EXPECT_LT(difference, 1e-12) << exponent;
    }
  }
}

TEST(Glyphs, AreNoLargerThanTheSurface)
{
  const Surface surface = Meshes::Potato(2);
  const Result result = Compute(surface, 4);
  Vector3 lower = surface.Points[0];
  Vector3 upper = lower;
  for (const Vector3& point : surface.Points)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  const double diagonal = (upper - lower).norm();
  for (const double spacing : { 3.0, 1e8, 1e300, std::numeric_limits<double>::infinity() })
  {
    GlyphOptions options;
    options.Spacing = spacing;
    const Glyphs glyphs = MakeGlyphs(surface, Of(result), {}, {}, options);
    EXPECT_GE(glyphs.Point.size(), 1u);
    EXPECT_LE(glyphs.Spacing, diagonal);
    EXPECT_GE(glyphs.Spacing, std::min(spacing, 0.999 * diagonal));
    for (const Vector3& place : glyphs.Mesh.Points)
    {
      EXPECT_LT((place - 0.5 * (lower + upper)).norm(), 1.1 * diagonal);
    }
  }
}

TEST(Glyphs, RefuseOptionsOutOfRange)
{
  const Surface surface = Meshes::Octahedron();
  const Result result = Compute(surface, 4);
  const double bad[] = { std::nan(""), -2.0, 11.0, std::numeric_limits<double>::infinity() };
  for (const double value : bad)
  {
    GlyphOptions options;
    options.Scale = value;
    EXPECT_THROW(MakeGlyphs(surface, Of(result), {}, {}, options), std::invalid_argument);
    options = {};
    options.Offset = value;
    EXPECT_THROW(MakeGlyphs(surface, Of(result), {}, {}, options), std::invalid_argument);
    options = {};
    options.Spacing = value;
    if (!(value >= 0.0))
    {
      EXPECT_THROW(MakeGlyphs(surface, Of(result), {}, {}, options), std::invalid_argument);
    }
  }
  GlyphOptions none;
  none.MaximumNumber = -1;
  EXPECT_THROW(MakeGlyphs(surface, Of(result), {}, {}, none), std::invalid_argument);
}

namespace
{
/// The processor time in seconds that glyphs with any directions take.
double TimeOfGlyphs(const Surface& surface, int degree)
{
  const PointDirections field = PlanarField(surface, degree, [](const Vector3&) { return 0.3; });
  GlyphOptions options;
  options.MaximumNumber = 2000;
  const std::clock_t begin = std::clock();
  const Glyphs glyphs = MakeGlyphs(surface, field, {}, {}, options);
  EXPECT_GT(glyphs.Point.size(), 1000u);
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}
}

TEST(Glyphs, NeitherManyTrianglesAtAPointNorCrowdsTakeLong)
{
  // The factors are generous; they were 400 and more where time was the square of the triangles.
  const double even = TimeOfGlyphs(Meshes::Square(140), 4);
  Surface cone;
  cone.Points.emplace_back(0.0, 0.0, 0.5);
  constexpr Index around = 40000;
  for (Index i = 0; i < around; ++i)
  {
    const double angle = 2.0 * Pi * i / around;
    cone.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    cone.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % around });
  }
  EXPECT_LT(TimeOfGlyphs(cone, 4), 40.0 * even);
  EXPECT_LT(TimeOfGlyphs(cone, 2), 40.0 * even);

  Surface crowd;
  std::mt19937 engine(1);
  const auto random = [&engine] { return engine() / 4294967296.0; };
  for (Index t = 0; t < 8000; ++t)
  {
    crowd.Triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
    for (int c = 0; c < 3; ++c)
    {
      const double x = random();
      const double y = random();
      crowd.Points.emplace_back(x, y, random());
    }
  }
  EXPECT_LT(TimeOfGlyphs(crowd, 4), 80.0 * even);
}
