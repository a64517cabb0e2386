// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Drawing/Stripes/Patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Patterns;

namespace
{
Vector3 PolygonArea(const StripePattern& pattern, std::size_t i)
{
  Vector3 area = Vector3::Zero();
  const Vector3& first = pattern.BandPositions[pattern.BandCorners[pattern.BandOffsets[i]]];
  for (std::int64_t k = pattern.BandOffsets[i] + 1; k + 1 < pattern.BandOffsets[i + 1]; ++k)
  {
    area += 0.5 *
      (pattern.BandPositions[pattern.BandCorners[k]] - first)
        .cross(pattern.BandPositions[pattern.BandCorners[k + 1]] - first);
  }
  return area;
}
}

TEST(StripeBands, AreTheSurfaceCutExactly)
{
  for (const Surface& surface : { Meshes::Icosphere(3), Meshes::Potato(4), Meshes::Hemisphere(3) })
  {
    for (const int degree : { 1, 2 })
    {
      // Down to several stripes within an edge.
      for (const double spacing : { 0.3, 0.1, 0.03 })
      {
        const StripePattern pattern = SmoothPattern(surface, degree, Spaced(spacing));
        std::set<std::pair<std::int64_t, std::int64_t>> sides;
        double area = 0.0;
        double dark = 0.0;
        for (std::size_t i = 0; i + 1 < pattern.BandOffsets.size(); ++i)
        {
          const std::int64_t begin = pattern.BandOffsets[i];
          const std::int64_t end = pattern.BandOffsets[i + 1];
          for (std::int64_t k = begin; k < end; ++k)
          {
            const std::int64_t next = k + 1 < end ? k + 1 : begin;
            EXPECT_TRUE(sides.insert({ pattern.BandCorners[k], pattern.BandCorners[next] }).second);
          }
          const double own = PolygonArea(pattern, i).norm();
          area += own;
          dark += pattern.Stripe[i] ? own : 0.0;
        }
        EXPECT_NEAR(area, AreaOf(surface), 1e-9 * area)
          << "polygons neither overlap nor leave gaps";
        EXPECT_NEAR(dark, 0.5 * area, 0.03 * area);
        int open = 0;
        for (const auto& [a, b] : sides)
        {
          open += sides.count({ b, a }) == 0 ? 1 : 0;
        }
        EXPECT_EQ(open > 0, surface.Triangles.size() == Meshes::Hemisphere(3).Triangles.size());
      }
    }
  }
}

TEST(StripeBands, PhasesSayWhichStripeTheyAre)
{
  const Surface surface = Meshes::Potato(3);
  for (const int degree : { 1, 2 })
  {
    StripeOptions options = Spaced(0.3);
    options.BandPhases = true;
    const StripePattern pattern = SmoothPattern(surface, degree, options);
    ASSERT_EQ(pattern.BandPhases.size(), pattern.BandCorners.size());
    for (std::size_t i = 0; i + 1 < pattern.BandOffsets.size(); ++i)
    {
      double mean = 0.0;
      for (std::int64_t k = pattern.BandOffsets[i]; k < pattern.BandOffsets[i + 1]; ++k)
      {
        mean += pattern.BandPhases[k] /
          static_cast<double>(pattern.BandOffsets[i + 1] - pattern.BandOffsets[i]);
      }
      EXPECT_EQ(std::cos(2.0 * Pi * mean) > 0.0, pattern.Stripe[i] != 0) << mean;
    }
  }
}

TEST(StripeBands, HaveTheirLinesInTheMiddle)
{
  const Surface surface = Meshes::Potato(4);
  for (const int degree : { 1, 2 })
  {
    for (const double offset : { 0.0, 0.5 })
    {
      StripeOptions options = Spaced(0.2);
      options.LineOffset = offset;
      options.BandPhases = true;
      const StripePattern pattern = SmoothPattern(surface, degree, options);
      // Along the edges of polygons the phase is linear; where it is 0, modulo 1, there is a line.
      std::set<std::array<long, 3>> places;
      const auto key = [](const Vector3& p)
      {
        return std::array<long, 3>{ std::lround(1e6 * p.x()), std::lround(1e6 * p.y()),
          std::lround(1e6 * p.z()) };
      };
      for (const Vector3& p : pattern.LinePositions)
      {
        places.insert(key(p));
      }
      // Near centers both are broken up in ways of their own.
      std::set<Index> centers;
      for (const StripeSingularity& singularity : pattern.Singularities)
      {
        centers.insert(singularity.Triangle);
      }
      int missing = 0;
      int found = 0;
      for (std::size_t i = 0; i + 1 < pattern.BandOffsets.size(); ++i)
      {
        const std::int64_t begin = pattern.BandOffsets[i];
        const std::int64_t end = pattern.BandOffsets[i + 1];
        for (std::int64_t k = begin; k < end && centers.count(pattern.BandTriangle[i]) == 0; ++k)
        {
          const std::int64_t next = k + 1 < end ? k + 1 : begin;
          const double from = pattern.BandPhases[k];
          const double to = pattern.BandPhases[next];
          const double level = std::ceil(std::min(from, to));
          if (level < std::max(from, to))
          {
            const double part = (level - from) / (to - from);
            const Vector3 place = (1.0 - part) * pattern.BandPositions[pattern.BandCorners[k]] +
              part * pattern.BandPositions[pattern.BandCorners[next]];
            bool near = false;
            const std::array<long, 3> here = key(place);
            for (long x = -2; x <= 2; ++x)
            {
              for (long y = -2; y <= 2; ++y)
              {
                for (long z = -2; z <= 2; ++z)
                {
                  near = near || places.count({ here[0] + x, here[1] + y, here[2] + z }) > 0;
                }
              }
            }
            missing += near ? 0 : 1;
            ++found;
          }
        }
      }
      EXPECT_GT(found, 100);
      EXPECT_EQ(missing, 0) << "of " << found;
    }
  }
}

TEST(StripeBands, CoverAnySurfaceWhateverTheField)
{
  Surface fins = Meshes::Icosphere(1);
  for (const double x : { 2.0, 2.5 })
  {
    // Edges of three triangles and four.
    fins.Points.emplace_back(x, 0.3, 0.1);
    fins.Triangles.push_back(
      { fins.Triangles[0][0], fins.Triangles[0][1], static_cast<Index>(fins.Points.size()) - 1 });
  }
  const std::vector<Surface> surfaces = { Meshes::Tetrahedron(), Meshes::Octahedron(),
    Meshes::BadSphere(3, 0.1, 1), Meshes::Scrambled(Meshes::Square(12), 2),
    Meshes::KleinBottle(24, 12), Meshes::ProjectivePlane(2), Meshes::MoebiusStrip(5),
    Meshes::Soup(Meshes::Icosphere(1)), fins, Meshes::Joined(Meshes::Cube(), Meshes::Disk(4)) };
  for (std::size_t k = 0; k < surfaces.size(); ++k)
  {
    const Surface& surface = surfaces[k];
    for (const int degree : { 1, 2 })
    {
      // Directions that have nothing to do with each other.
      PointDirections noise;
      noise.Degree = degree;
      noise.Direction = [degree](Index point, int direction)
      {
        const double sign = degree == 2 && direction == 1 ? -1.0 : 1.0;
        return Vector3(sign * std::sin(12.9898 * point + 1.0), sign * std::sin(78.233 * point),
          sign * std::cos(37.719 * point));
      };
      noise.Magnitude = [](Index point) { return point % 7 == 3 ? 0.0 : 1.0; };
      for (const double spacing : { 0.0, 0.07 })
      {
        const StripePattern pattern = PatternOf(surface, noise, Spaced(spacing));
        double area = 0.0;
        for (std::size_t i = 0; i + 1 < pattern.BandOffsets.size(); ++i)
        {
          area += PolygonArea(pattern, i).norm();
        }
        EXPECT_NEAR(area, AreaOf(surface), 1e-6 * area) << "surface " << k << ", degree " << degree;
        int unpaired = 0;
        for (std::size_t i = 0; i < pattern.Closed.size(); ++i)
        {
          const Vector3 begin = pattern.LinePositions[pattern.LineOffsets[i]];
          const Vector3 end = pattern.LinePositions[pattern.LineOffsets[i + 1] - 1];
          EXPECT_TRUE(begin.allFinite() && end.allFinite());
          unpaired += pattern.Closed[i] != 0 && begin != end ? 1 : 0;
        }
        EXPECT_EQ(unpaired, 0);
      }
    }
  }
}
