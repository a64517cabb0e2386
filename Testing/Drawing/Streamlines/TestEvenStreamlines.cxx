// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/FieldInterpolant.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Streamlines.h"
#include "Streamlines/EvenStreamlines.h"
#include "Streamlines/LineGrid.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;

namespace
{
Streamlines LinesOf(const Surface& surface, int degree, const StreamlineOptions& options = {})
{
  const Result result = Fields::Compute(surface, degree);
  const PointDirections directions = Fields::Of(result);
  const GivenField field(surface, directions);
  return TraceStreamlines(field, directions, {}, options);
}

StreamlineOptions OnSurface(double spacing = 0.0)
{
  StreamlineOptions options;
  options.Offset = 0.0;
  options.Spacing = spacing;
  return options;
}

/// Points along a line, no more than a length apart.
std::vector<LineSample> Samples(const Streamlines& lines, std::size_t line, double step)
{
  std::vector<LineSample> samples;
  for (std::int64_t p = lines.Offsets[line]; p + 1 < lines.Offsets[line + 1]; ++p)
  {
    const Vector3 along = lines.Points[p + 1] - lines.Points[p];
    const int parts = static_cast<int>(along.norm() / step) + 1;
    for (int k = 0; k < parts; ++k)
    {
      LineSample sample;
      sample.Position = lines.Points[p] + (static_cast<double>(k) / parts) * along;
      sample.Normal = lines.Normals[p];
      sample.Tangent = lines.Directions[p];
      sample.Arc = static_cast<double>(line);
      samples.push_back(sample);
    }
  }
  return samples;
}

std::vector<Surface> ManySurfaces()
{
  return { Meshes::Potato(3), Meshes::Torus(48, 24), Meshes::ChamferedCube(6),
    Meshes::Hemisphere(3), Meshes::PlateWithHole(48, 8, 0.4, false) };
}
}

TEST(EvenStreamlines, KeepTheirDistanceFromOthersOfTheirFamily)
{
  for (const Surface& surface : ManySurfaces())
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Streamlines lines = LinesOf(surface, degree, OnSurface());
      ASSERT_GT(lines.Length.size(), 0u);
      const int families = degree % 2 == 0 ? degree / 2 : degree;
      LineGrid grid(surface.Points[0], lines.Spacing, families, false);
      std::vector<std::vector<LineSample>> all;
      for (std::size_t i = 0; i < lines.Length.size(); ++i)
      {
        all.push_back(Samples(lines, i, 0.1 * lines.Spacing));
        for (const LineSample& sample : all.back())
        {
          grid.Insert(sample);
        }
      }
      int close = 0;
      int count = 0;
      for (const auto& samples : all)
      {
        for (const LineSample& sample : samples)
        {
          ++count;
          close += grid.IsNear(sample, 0.45 * lines.Spacing,
                     [&](const LineSample& other) { return other.Arc != sample.Arc; })
            ? 1
            : 0;
        }
      }
      EXPECT_EQ(close, 0) << "of " << count << ", degree " << degree << ", "
                          << surface.Triangles.size() << " triangles";
    }
  }
}

TEST(EvenStreamlines, LeaveNoGaps)
{
  for (const Surface& surface : ManySurfaces())
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Streamlines lines = LinesOf(surface, degree, OnSurface());
      LineGrid grid(surface.Points[0], 1.2 * lines.Spacing, 1, false);
      for (std::size_t i = 0; i < lines.Length.size(); ++i)
      {
        for (const LineSample& sample : Samples(lines, i, 0.1 * lines.Spacing))
        {
          grid.Insert(sample);
        }
      }
      int far = 0;
      for (const Triangle& triangle : surface.Triangles)
      {
        const Vector3& a = surface.Points[triangle[0]];
        const Vector3& b = surface.Points[triangle[1]];
        const Vector3& c = surface.Points[triangle[2]];
        LineSample place;
        place.Position = (a + b + c) / 3.0;
        place.Normal = (b - a).cross(c - a).normalized();
        place.Tangent = (b - a).normalized();
        far += grid.IsNear(place, 1.1 * lines.Spacing) ? 0 : 1;
      }
      EXPECT_EQ(far, 0) << "degree " << degree << ", " << surface.Triangles.size() << " triangles";
    }
  }
}

TEST(EvenStreamlines, FollowTheDirectionsWithinFiveDegrees)
{
  // Each chord against the direction of the field in its middle, in the flat triangle; all of them
  // but those into a singularity, the last hundredth of a triangle's size, where the field has no
  // direction.
  constexpr double intoSingularity = 0.015;
  for (const Surface& surface : ManySurfaces())
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Result result = Fields::Compute(surface, degree);
      const PointDirections directions = Fields::Of(result);
      const GivenField field(surface, directions);
      const SingularPoints zeros(field);
      EvenOptions options;
      options.Spacing = std::sqrt(field.GetGeometry().Lengths.ComponentArea[0]) *
        field.GetGeometry().Lengths.Unit[0] / 40.0;
      options.MaximumLength = 500.0 * options.Spacing;
      options.MinimumLength = options.Spacing;
      options.MaximumNumber = 100000;
      double most = 0.0;
      int count = 0;
      for (const TracedStreamline& line :
        TraceEvenStreamlines(field, zeros, 0, options, {}, Progress()))
      {
        for (std::size_t i = 0; i < line.Pieces.size(); ++i)
        {
          const LinePiece& piece = line.Pieces[i];
          const FieldInterpolant power(
            field.GetGeometry(), degree, field.GetSection().data(), piece.Triangle);
          const double size = std::sqrt(2.0 * power.Flat().Area());
          const double left = line.Pieces.back().Arc + line.Pieces.back().Length() - piece.Arc;
          const double done = piece.Arc + piece.Length() - line.Pieces.front().Arc;
          const bool isInto =
            (line.Ends[0] == StreamlineEnd::Singularity && done < intoSingularity * size) ||
            (line.Ends[1] == StreamlineEnd::Singularity && left < intoSingularity * size);
          // A chord that is no longer than rounding has no direction.
          if (!isInto && piece.Length() > 1e-7 * size)
          {
            const Complex chord = (piece.End - piece.Begin) / piece.Length();
            const Complex value = power.At(0.5 * (piece.Begin + piece.End));
            const Complex against = value * std::conj(IntegerPower(chord, degree)) *
              (degree % 2 == 1 && std::real(value * std::conj(IntegerPower(chord, degree))) < 0.0
                  ? -1.0
                  : 1.0);
            most = std::max(most, std::abs(std::arg(against)) / degree);
            ++count;
          }
        }
      }
      EXPECT_GT(count, 1000);
      EXPECT_LT(most * 180.0 / Pi, 5.0) << "degree " << degree << ", " << surface.Triangles.size();
    }
  }
}

TEST(EvenStreamlines, HaveTheSameBytesForAnyNumberOfThreads)
{
  for (const int degree : { 1, 2, 4 })
  {
    for (const SeedType seeds : { SeedType::EvenlySpaced, SeedType::Singularities })
    {
      StreamlineOptions options;
      options.Seeds = seeds;
      options.StopAtCrossings = degree == 4;
      options.MaximumLength = 8.0;
      std::vector<Vector3> points;
      std::vector<std::int64_t> offsets;
      for (const int number : { 1, 2, 5 })
      {
        Threads threads(number);
        const Threads::Scope scope(threads);
        const Streamlines lines =
          LinesOf(Meshes::Joined(Meshes::Potato(3), Meshes::Torus(30, 16)), degree, options);
        if (number > 1)
        {
          EXPECT_TRUE(lines.Points == points);
          EXPECT_EQ(lines.Offsets, offsets);
        }
        points = lines.Points;
        offsets = lines.Offsets;
      }
    }
  }
}

TEST(EvenStreamlines, TurnGrowAndAreRenumberedWithTheSurface)
{
  const Surface surface = Meshes::Potato(3);
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  const Eigen::Matrix3d rotation = Meshes::ObliqueRotation(0.9);
  const Vector3 shift(5, -3, 2);
  constexpr double scale = 40.0;
  const Surface moved = Meshes::Transformed(
    Meshes::Shuffled(surface, 4, newPoint, newTriangle), scale * rotation, shift);
  for (const int degree : { 2, 4 })
  {
    const Result result = Fields::Compute(surface, degree, 0.0, 1e-12);
    const PointDirections directions = Fields::Of(result);
    std::vector<Index> oldPoint(newPoint.size());
    for (std::size_t i = 0; i < newPoint.size(); ++i)
    {
      oldPoint[newPoint[i]] = static_cast<Index>(i);
    }
    PointDirections turned = directions;
    turned.Direction = [&](Index point, int k)
    { return Vector3(rotation * directions.Direction(oldPoint[point], k)); };
    turned.Magnitude = [&](Index point) { return directions.Magnitude(oldPoint[point]); };
    for (const SeedType seeds : { SeedType::EvenlySpaced, SeedType::Singularities })
    {
      StreamlineOptions options = OnSurface();
      options.Seeds = seeds;
      // Long lines magnify rounding.
      options.MaximumLength = 4.0;
      const GivenField one(surface, directions);
      const Streamlines lines = TraceStreamlines(one, directions, {}, options);
      options.MaximumLength *= scale;
      const GivenField two(moved, turned);
      const Streamlines others = TraceStreamlines(two, turned, {}, options);
      ASSERT_EQ(lines.Length.size(), others.Length.size()) << degree;
      // The same lines in any order and sense: by their lengths and middles.
      std::multiset<long> here;
      std::multiset<long> there;
      for (std::size_t i = 0; i < lines.Length.size(); ++i)
      {
        here.insert(std::lround(1e4 * lines.Length[i]));
        there.insert(std::lround(1e4 * others.Length[i] / scale));
      }
      int same = 0;
      for (const long length : here)
      {
        for (const long near : { length, length - 1, length + 1 })
        {
          const auto found = there.find(near);
          if (found != there.end())
          {
            there.erase(found);
            ++same;
            break;
          }
        }
      }
      EXPECT_EQ(same, static_cast<int>(here.size())) << degree;
    }
  }
}

TEST(EvenStreamlines, MayBeShorterThanTheirSpacingButNotThanAllowed)
{
  StreamlineOptions options = OnSurface(0.4);
  options.MaximumLength = 0.1;
  const Streamlines lines = LinesOf(Meshes::Torus(48, 24), 4, options);
  ASSERT_GT(lines.Length.size(), 4u);
  for (const double length : lines.Length)
  {
    EXPECT_GE(length, 0.9 * options.MaximumLength);
    // Lines end within the triangle in which they have become long enough.
    EXPECT_LE(length, 1.5 * options.MaximumLength);
  }
  // No line is that long, and to look for one took seconds.
  options.MinimumLength = 0.11;
  try
  {
    LinesOf(Meshes::Torus(48, 24), 4, options);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("MaximumStreamlineLength"), std::string::npos);
  }
  options.MaximumLength = 0.0;
  options.MinimumLength = 1e6;
  EXPECT_EQ(LinesOf(Meshes::Torus(48, 24), 4, options).Length.size(), 0u);
}
