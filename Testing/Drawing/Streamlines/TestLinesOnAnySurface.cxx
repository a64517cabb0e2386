// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "MeshError.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Streamlines.h"
#include "Streamlines/LineGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace DirectionFields;

namespace
{
StreamlineOptions OnSurface(SeedType seeds = SeedType::EvenlySpaced)
{
  StreamlineOptions options;
  options.Seeds = seeds;
  options.Offset = 0.0;
  return options;
}

/// The same direction everywhere, along an axis of space.
PointDirections Along(const Vector3& axis, int degree)
{
  PointDirections directions;
  directions.Degree = degree;
  directions.Direction = [axis, degree](Index, int k)
  {
    const double angle = 2.0 * Pi * k / degree;
    return Vector3(std::cos(angle) * axis + std::sin(angle) * Vector3::UnitZ().cross(axis));
  };
  directions.Magnitude = [](Index) { return 1.0; };
  return directions;
}

LineSample SampleOf(const Streamlines& lines, std::int64_t point, std::size_t line)
{
  LineSample sample;
  sample.Position = lines.Points[point];
  sample.Normal = lines.Normals[point];
  sample.Tangent = lines.Directions[point];
  sample.Arc = static_cast<double>(line);
  return sample;
}
}

TEST(LinesOnAnySurface, CloseAroundATorus)
{
  // Fine enough for lines to come back to their start by less than the distance at which they
  // close.
  const Surface torus = Meshes::Torus(120, 60);
  PointDirections around;
  around.Degree = 1;
  around.Direction = [&](Index point, int)
  {
    const Vector3& p = torus.Points[point];
    return Vector3(-p.y(), p.x(), 0.0).normalized();
  };
  around.Magnitude = [](Index) { return 1.0; };
  const GivenField field(torus, around);
  const Streamlines lines = TraceStreamlines(field, around, {}, OnSurface());
  ASSERT_GT(lines.Length.size(), 10u);
  int closed = 0;
  for (std::size_t i = 0; i < lines.Length.size(); ++i)
  {
    const Vector3& begin = lines.Points[lines.Offsets[i]];
    EXPECT_NE(lines.Ends[i][0], StreamlineEnd::Boundary);
    EXPECT_NE(lines.Ends[i][1], StreamlineEnd::Boundary);
    if (lines.Closed[i] != 0)
    {
      ++closed;
      EXPECT_EQ(begin, lines.Points[lines.Offsets[i + 1] - 1]);
      // Once around the axis, along a circle but for the chords.
      const double circle = 2.0 * Pi * std::hypot(begin.x(), begin.y());
      EXPECT_NEAR(lines.Length[i], circle, 0.02 * circle);
    }
  }
  EXPECT_GE(closed, static_cast<int>(lines.Length.size()) - 1);
}

TEST(LinesOnAnySurface, EndAtEdgesOfMoreThanTwoTriangles)
{
  // Two half-planes and a wall on the line between them, which the field runs across.
  Surface surface = Meshes::Square(8);
  const auto before = static_cast<Index>(surface.Points.size());
  std::vector<std::pair<double, Index>> middle;
  for (Index i = 0; i < before; ++i)
  {
    if (std::abs(surface.Points[i].x() - 0.5) < 1e-9)
    {
      middle.emplace_back(surface.Points[i].y(), i);
    }
  }
  std::sort(middle.begin(), middle.end());
  ASSERT_EQ(middle.size(), 9u);
  for (const auto& [y, i] : middle)
  {
    surface.Points.emplace_back(0.5, y, 0.3);
  }
  for (Index k = 0; k + 1 < static_cast<Index>(middle.size()); ++k)
  {
    surface.Triangles.push_back({ middle[k].second, middle[k + 1].second, before + k });
    surface.Triangles.push_back({ middle[k + 1].second, before + k + 1, before + k });
  }
  const PointDirections directions = Along(Vector3::UnitX(), 1);
  const GivenField field(surface, directions);
  for (Index t = 0; t < static_cast<Index>(surface.Triangles.size()) - 16; t += 5)
  {
    const Streamlines lines = TraceStreamlines(
      field, directions, { { t, { 0.3, 0.3, 0.4 } } }, OnSurface(SeedType::Points));
    ASSERT_EQ(lines.Length.size(), 1u);
    EXPECT_EQ(lines.Ends[0][0], StreamlineEnd::Boundary);
    EXPECT_EQ(lines.Ends[0][1], StreamlineEnd::Boundary);
    EXPECT_NEAR(lines.Length[0], 0.5, 1e-6);
  }
}

TEST(LinesOnAnySurface, RunIntoGhostsButDoNotStartThere)
{
  // The right half is another piece's, and so is all of a second square.
  Surface surface = Meshes::Joined(Meshes::Square(24),
    Meshes::Transformed(Meshes::Square(24), Eigen::Matrix3d::Identity(), Vector3(3, 0, 0)));
  for (const Triangle& triangle : surface.Triangles)
  {
    const double x =
      (surface.Points[triangle[0]] + surface.Points[triangle[1]] + surface.Points[triangle[2]])
        .x() /
      3.0;
    surface.Ghost.push_back(x > 0.5 ? 1 : 0);
  }
  const PointDirections directions = Along(Vector3(0.6, 0.8, 0.0), 2);
  const GivenField field(surface, directions);
  const Streamlines lines = TraceStreamlines(field, directions, {}, OnSurface());
  ASSERT_GT(lines.Length.size(), 5u);
  int intoGhosts = 0;
  for (std::size_t i = 0; i < lines.Length.size(); ++i)
  {
    double least = 1e300;
    double most = -1e300;
    for (std::int64_t p = lines.Offsets[i]; p < lines.Offsets[i + 1]; ++p)
    {
      least = std::min(least, lines.Points[p].x());
      most = std::max(most, lines.Points[p].x());
    }
    EXPECT_LE(least, 0.5);
    EXPECT_LE(most, 1.0 + 1e-9);
    intoGhosts += most > 0.6 ? 1 : 0;
  }
  EXPECT_GT(intoGhosts, 2);
}

TEST(LinesOnAnySurface, CoverBothSidesOfWhatCannotBeOrientedOnce)
{
  for (const Surface& surface : { Meshes::MoebiusStrip(60, 8), Meshes::KleinBottle(40, 24) })
  {
    for (const int degree : { 2, 4 })
    {
      const Result result = Fields::Compute(surface, degree);
      const PointDirections directions = Fields::Of(result);
      const GivenField field(surface, directions);
      ASSERT_TRUE(field.GetMesh().GetComponents()[0].IsCover);
      const Streamlines lines = TraceStreamlines(field, directions, {}, OnSurface());
      ASSERT_GT(lines.Length.size(), 2u);
      // One side counts as the other.
      LineGrid grid(surface.Points[0], lines.Spacing, degree / 2, true);
      LineGrid any(surface.Points[0], 1.2 * lines.Spacing, 1, true);
      for (std::size_t i = 0; i < lines.Length.size(); ++i)
      {
        for (std::int64_t p = lines.Offsets[i]; p < lines.Offsets[i + 1]; ++p)
        {
          grid.Insert(SampleOf(lines, p, i));
          any.Insert(SampleOf(lines, p, i));
        }
      }
      int close = 0;
      for (std::size_t i = 0; i < lines.Length.size(); ++i)
      {
        for (std::int64_t p = lines.Offsets[i]; p < lines.Offsets[i + 1]; ++p)
        {
          const LineSample sample = SampleOf(lines, p, i);
          close += grid.IsNear(sample, 0.45 * lines.Spacing,
                     [&](const LineSample& other) { return other.Arc != sample.Arc; })
            ? 1
            : 0;
        }
      }
      EXPECT_EQ(close, 0) << degree;
      int far = 0;
      for (const Triangle& triangle : surface.Triangles)
      {
        LineSample place;
        place.Position = (surface.Points[triangle[0]] + surface.Points[triangle[1]] +
                           surface.Points[triangle[2]]) /
          3.0;
        place.Normal = Vector3::UnitZ();
        place.Tangent = Vector3::UnitX();
        far += any.IsNear(place, 1.1 * lines.Spacing) ? 0 : 1;
      }
      EXPECT_EQ(far, 0) << degree;
    }
  }
}

TEST(LinesOnAnySurface, GetOnOverSlivers)
{
  for (const unsigned seed : { 3u })
  {
    const Surface surface = Meshes::BadSphere(2, 0.6, seed);
    for (const int degree : { 1, 2, 4 })
    {
      const Result result = Fields::Compute(surface, degree);
      const PointDirections directions = Fields::Of(result);
      const GivenField field(surface, directions);
      for (const SeedType seeds : { SeedType::EvenlySpaced, SeedType::Singularities })
      {
        StreamlineOptions options = OnSurface(seeds);
        options.MaximumLength = 12.0;
        const Streamlines lines = TraceStreamlines(field, directions, {}, options);
        EXPECT_TRUE(seeds == SeedType::Singularities || !lines.Length.empty());
        for (const auto& ends : lines.Ends)
        {
          for (const StreamlineEnd end : ends)
          {
            EXPECT_NE(end, StreamlineEnd::Boundary) << "a line has left a closed surface";
            EXPECT_NE(end, StreamlineEnd::Stuck);
          }
        }
      }
    }
  }
}

TEST(LinesOnAnySurface, DoNotWindAroundSpikesOfAnyLength)
{
  for (const double spike : { 1e2, 1e3, 1e100 })
  {
    Surface surface = Meshes::Potato(3);
    surface.Points[100] *= spike;
    const Result result = Fields::Compute(surface, 4);
    const PointDirections directions = Fields::Of(result);
    const GivenField field(surface, directions);
    StreamlineOptions options = OnSurface();
    options.MaximumNumber = spike > 1e3 ? 3 : 1000;
    const Streamlines lines = TraceStreamlines(field, directions, {}, options);
    ASSERT_FALSE(lines.Length.empty());
    for (std::size_t i = 0; i < lines.Length.size(); ++i)
    {
      Vector3 low = lines.Points[lines.Offsets[i]];
      Vector3 high = low;
      for (std::int64_t k = lines.Offsets[i]; k < lines.Offsets[i + 1]; ++k)
      {
        ASSERT_TRUE(lines.Points[k].allFinite());
        low = low.cwiseMin(lines.Points[k]);
        high = high.cwiseMax(lines.Points[k]);
      }
      EXPECT_GT((high - low).stableNorm(), std::min(0.25 * lines.Length[i], 0.5 * lines.Spacing));
    }
  }
}

TEST(LinesOnAnySurface, AreFiniteOrRefusedWhereCoordinatesAreAtTheEndOfNumbers)
{
  // A point that is far, and a surface that is large as a whole.
  for (const bool isWhole : { false, true })
  {
    for (const SeedType seeds : { SeedType::EvenlySpaced, SeedType::Singularities })
    {
      Surface surface = Meshes::Potato(3);
      const Result result = Fields::Compute(surface, 4);
      const PointDirections directions = Fields::Of(result);
      const auto stretch = [&surface, isWhole](double factor)
      {
        for (std::size_t p = isWhole ? 0 : 100; p < (isWhole ? surface.Points.size() : 101); ++p)
        {
          surface.Points[p] *= factor;
        }
      };
      stretch(1e299);
      const GivenField field(surface, directions);
      StreamlineOptions options = OnSurface(seeds);
      options.MaximumNumber = 3;
      const Streamlines lines = TraceStreamlines(field, directions, {}, options);
      EXPECT_FALSE(lines.Length.empty());
      for (std::size_t p = 0; p < lines.Points.size(); ++p)
      {
        ASSERT_TRUE(lines.Points[p].allFinite() && std::isfinite(lines.Arc[p]));
        ASSERT_NEAR(lines.Directions[p].norm(), 1.0, 1e-9);
      }
      stretch(1e3);
      EXPECT_THROW(GivenField(surface, directions), MeshError);
      DirectionField anew(surface);
      EXPECT_THROW(anew.Compute({}), MeshError);
    }
  }
}
