// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/DiskGrid.h"
#include "Glyphs/SurfaceSampling.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace DirectionFields;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Sampled
{
  explicit Sampled(
    Surface surface, const SamplingOptions& options = {}, const std::vector<char>& excluded = {})
    : Mesh(std::move(surface))
    , Incidence(Mesh)
    , Samples(SampleSurface(Incidence, excluded, options))
  {
    for (const SurfacePoint& point : Samples.Points)
    {
      Position.push_back(point.Position(Incidence));
      Normal.push_back(Incidence.Normal(point.Triangle));
    }
  }

  /// Least distance between samples on the same side.
  double LeastDistance() const
  {
    double least = Infinity;
    for (std::size_t i = 0; i < Position.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (IsSameSide(Normal[i].cast<float>().eval(), Normal[j].cast<float>().eval()))
        {
          least = std::min(least, (Position[i] - Position[j]).norm());
        }
      }
    }
    return least;
  }

  /// Largest distance from a corner or the middle of a triangle to the nearest sample on its side.
  double LargestGap() const
  {
    double largest = 0.0;
    for (Index t = 0; t < Incidence.GetNumberOfTriangles(); ++t)
    {
      const Vector3 normal = Incidence.Normal(t);
      for (int c = 0; c < 4; ++c)
      {
        const Vector3 place = c < 3
          ? Incidence.Corner(t, c)
          : Vector3((Incidence.Corner(t, 0) + Incidence.Corner(t, 1) + Incidence.Corner(t, 2)) / 3);
        double gap = Infinity;
        for (std::size_t i = 0; i < Position.size(); ++i)
        {
          if (IsSameSide(Normal[i].cast<float>().eval(), normal.cast<float>().eval()))
          {
            gap = std::min(gap, (Position[i] - place).norm());
          }
        }
        largest = std::max(largest, gap);
      }
    }
    return largest;
  }

  Sampled(const Sampled&) = delete;
  void operator=(const Sampled&) = delete;

  Surface Mesh;
  SurfaceIncidence Incidence;
  SurfaceSamples Samples;
  std::vector<Vector3> Position;
  std::vector<Vector3> Normal;
};

SamplingOptions WithSpacing(double spacing, Index maximumNumber = 100000)
{
  SamplingOptions options;
  options.Spacing = spacing;
  options.MaximumNumber = maximumNumber;
  return options;
}

SamplingOptions WithNumber(Index number)
{
  return WithSpacing(0.0, number);
}

/// Two squares back to back, a hundredth of their size apart.
Surface Sheet()
{
  Surface upper = Meshes::Square(20);
  Surface lower = Meshes::Transformed(upper, Eigen::Matrix3d::Identity(), { 0, 0, -0.01 });
  for (Triangle& triangle : lower.Triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  return Meshes::Joined(upper, lower);
}
}

TEST(SurfaceSampling, KeepsItsDistanceAndLeavesNoGap)
{
  const Surface meshes[] = { Meshes::Square(40), Meshes::Icosphere(4), Meshes::Torus(60, 30),
    Meshes::Cube(), Meshes::Cylinder(40, 20, 3.0), Meshes::Potato(4), Meshes::LShape(10), Sheet() };
  for (const Surface& surface : meshes)
  {
    for (const double spacing : { 0.35, 0.11 })
    {
      const Sampled sampled(surface, WithSpacing(spacing));
      EXPECT_EQ(sampled.Samples.Spacing, spacing);
      EXPECT_GE(sampled.LeastDistance(), spacing * (1.0 - 1e-9));
      EXPECT_LE(sampled.LargestGap(), 1.25 * spacing);
      for (const SurfacePoint& point : sampled.Samples.Points)
      {
        EXPECT_NEAR(point.Weights[0] + point.Weights[1] + point.Weights[2], 1.0, 1e-12);
        EXPECT_GE(*std::min_element(point.Weights.begin(), point.Weights.end()), 0.0);
      }
    }
  }
}

TEST(SurfaceSampling, IsEven)
{
  // Of the best distance that as many samples can have on a plane, that of a hexagonal lattice.
  // Darts thrown at random reach 0.77 in the mean, random points 0.47.
  const Sampled sampled(Meshes::Icosphere(5), WithNumber(1500));
  double sum = 0.0;
  for (std::size_t i = 0; i < sampled.Position.size(); ++i)
  {
    double nearest = Infinity;
    for (std::size_t j = 0; j < sampled.Position.size(); ++j)
    {
      const double distance = (sampled.Position[i] - sampled.Position[j]).norm();
      nearest = i == j ? nearest : std::min(nearest, distance);
    }
    sum += nearest;
  }
  const double count = static_cast<double>(sampled.Position.size());
  const double lattice = std::sqrt(2.0 / std::sqrt(3.0) * 4.0 * Pi / count);
  EXPECT_GT(sum / count, 0.83 * lattice);
}

TEST(SurfaceSampling, BothSidesOfASheetHaveSamples)
{
  const Sampled sampled(Sheet(), WithSpacing(0.1));
  const auto upper = std::count_if(
    sampled.Normal.begin(), sampled.Normal.end(), [](const Vector3& n) { return n.z() > 0.0; });
  const auto all = static_cast<std::ptrdiff_t>(sampled.Normal.size());
  EXPECT_GT(upper, 50);
  EXPECT_NEAR(static_cast<double>(upper), 0.5 * static_cast<double>(all), 0.1 * all);
}

TEST(SurfaceSampling, AutomaticSpacingComesNearTheNumber)
{
  const Surface meshes[] = { Meshes::Icosphere(4), Meshes::Torus(60, 30), Meshes::Square(30),
    Meshes::Cube(), Meshes::Cylinder(12, 200, 60.0) };
  for (const Surface& surface : meshes)
  {
    for (const Index number : { 1, 2, 5, 20, 100, 700, 3000 })
    {
      const Sampled sampled(surface, WithNumber(number));
      const auto count = static_cast<Index>(sampled.Samples.Points.size());
      EXPECT_LE(count, number);
      EXPECT_GE(count, number < 20 ? 1 : 0.85 * number) << number;
      EXPECT_GT(sampled.Samples.Spacing, 0.0);
    }
  }
}

TEST(SurfaceSampling, SpacingIsEnlargedToKeepTheNumber)
{
  const Sampled sampled(Meshes::Icosphere(4), WithSpacing(1e-6, 300));
  EXPECT_LE(sampled.Samples.Points.size(), 300u);
  EXPECT_GE(sampled.Samples.Points.size(), 255u);
  EXPECT_GT(sampled.Samples.Spacing, 0.1);
  EXPECT_GE(sampled.LeastDistance(), sampled.Samples.Spacing * (1.0 - 1e-9));

  // Sheets on top of each other need fewer samples than their area suggests: it is not enlarged.
  Surface stack;
  for (int i = 0; i < 20; ++i)
  {
    stack = Meshes::Joined(stack,
      Meshes::Transformed(Meshes::Square(10), Eigen::Matrix3d::Identity(), { 0, 0, 1e-4 * i }));
  }
  EXPECT_EQ(Sampled(stack, WithSpacing(0.1, 200)).Samples.Spacing, 0.1);
}

TEST(SurfaceSampling, LargeSpacingGivesOneSampleOfEachRemotePart)
{
  const Surface tiny =
    Meshes::Transformed(Meshes::Square(2), 1e-5 * Eigen::Matrix3d::Identity(), { 9, 0, 0 });
  const Sampled sampled(Meshes::Joined(Meshes::Square(5), tiny), WithSpacing(3.0));
  ASSERT_EQ(sampled.Position.size(), 2u);
  EXPECT_NEAR(std::abs(sampled.Position[0].x() - sampled.Position[1].x()), 8.5, 0.6);
}

TEST(SurfaceSampling, IsTheSameEachTime)
{
  const Surface surface = Meshes::Potato(4);
  const Sampled one(surface, WithNumber(500)), other(surface, WithNumber(500));
  ASSERT_EQ(one.Samples.Points.size(), other.Samples.Points.size());
  EXPECT_EQ(one.Samples.Spacing, other.Samples.Spacing);
  for (std::size_t i = 0; i < one.Samples.Points.size(); ++i)
  {
    EXPECT_EQ(one.Samples.Points[i].Triangle, other.Samples.Points[i].Triangle);
    EXPECT_EQ(one.Samples.Points[i].Weights, other.Samples.Points[i].Weights);
  }
}

TEST(SurfaceSampling, DoesNotDependOnTheUnit)
{
  for (const double unit : { 1e-7, 1e7 })
  {
    const Sampled sampled(
      Meshes::Transformed(Meshes::Torus(40, 20), unit * Eigen::Matrix3d::Identity(), { 0, 0, 0 }),
      WithNumber(400));
    EXPECT_GE(sampled.Samples.Points.size(), 340u);
    EXPECT_GE(sampled.LeastDistance(), sampled.Samples.Spacing * (1.0 - 1e-9));
    EXPECT_LE(sampled.LargestGap(), 1.25 * sampled.Samples.Spacing);
  }
}

TEST(SurfaceSampling, UnsoundAndExcludedTrianglesHaveNoSamples)
{
  Surface surface = Meshes::Square(10);
  const auto count = static_cast<Index>(surface.Triangles.size());
  surface.Points[3].y() = std::nan("");
  surface.Points[50].x() = Infinity;
  surface.Triangles.push_back({ 0, 1, 99999 });
  surface.Triangles.push_back({ 0, -1, 1 });
  surface.Triangles.push_back({ 5, 5, 6 });
  // Far away and without area, but for rounding.
  const auto first = static_cast<Index>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), { { 50, 0, 0 }, { 60, 1e-13, 0 }, { 70, 0, 0 } });
  surface.Triangles.push_back({ first, first + 1, first + 2 });
  std::vector<char> excluded(surface.Triangles.size(), 0);
  std::fill(excluded.begin(), excluded.begin() + count / 2, 1);
  const Sampled sampled(surface, WithSpacing(0.05), excluded);
  EXPECT_GT(sampled.Position.size(), 50u);
  for (std::size_t i = 0; i < sampled.Position.size(); ++i)
  {
    const Index t = sampled.Samples.Points[i].Triangle;
    EXPECT_TRUE(sampled.Position[i].allFinite());
    EXPECT_LT(t, count);
    EXPECT_GT(sampled.Incidence.Area(t), 0.0);
    EXPECT_EQ(excluded[t], 0);
  }

  // Samples move, but not there: every other square of a chess board.
  const Surface board = Meshes::Square(16);
  excluded.assign(board.Triangles.size(), 0);
  for (std::size_t t = 0; t < excluded.size(); ++t)
  {
    excluded[t] = static_cast<char>((t / 2 + t / 32) % 2);
  }
  for (const double spacing : { 0.05, 0.1, 0.2 })
  {
    const Sampled chess(board, WithSpacing(spacing), excluded);
    EXPECT_GT(chess.Position.size(), 10u);
    for (const SurfacePoint& point : chess.Samples.Points)
    {
      EXPECT_EQ(excluded[point.Triangle], 0);
    }
  }

  EXPECT_TRUE(Sampled(Surface()).Samples.Points.empty());
  surface.Triangles.resize(1);
  surface.Triangles[0] = { 1, 1, 1 };
  EXPECT_TRUE(Sampled(surface).Samples.Points.empty());
}

TEST(SurfaceSampling, CanBeStopped)
{
  const Surface surface = Meshes::Icosphere(4);
  const SurfaceIncidence incidence(surface);
  for (const double when : { 0.0, 0.2, 0.4 })
  {
    const ProgressFunction stop = [when](double done) { return done < when; };
    EXPECT_THROW(SampleSurface(incidence, {}, WithNumber(5000), Progress(stop)), Stopped);
  }
  const ProgressFunction never = [](double) { return false; };
  EXPECT_THROW(SamplePoints(incidence, {}, 10, Progress(never)), Stopped);

  double last = 0.0;
  const ProgressFunction watch = [&last](double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return true;
  };
  EXPECT_FALSE(SampleSurface(incidence, {}, WithNumber(5000), Progress(watch)).Points.empty());
  EXPECT_GT(last, 0.3);
}

TEST(SurfaceSampling, AllPointsOrAnEvenPartOfThem)
{
  Surface surface = Meshes::Icosphere(4);
  const auto used = surface.Points.size();
  // A point that no triangle uses.
  surface.Points.push_back({ 5, 5, 5 });
  const SurfaceIncidence incidence(surface);
  const auto pointOf = [&](const SurfacePoint& sample)
  {
    const auto corner = std::max_element(sample.Weights.begin(), sample.Weights.end());
    EXPECT_EQ(*corner, 1.0);
    return surface.Triangles[sample.Triangle][corner - sample.Weights.begin()];
  };
  const SurfaceSamples all = SamplePoints(incidence, {}, 100000);
  ASSERT_EQ(all.Points.size(), used);
  EXPECT_EQ(all.Spacing, 0.0);
  for (std::size_t i = 0; i < used; ++i)
  {
    EXPECT_EQ(pointOf(all.Points[i]), static_cast<Index>(i));
  }

  std::vector<char> excluded(surface.Points.size(), 0);
  std::fill(excluded.begin() + 100, excluded.end(), 1);
  EXPECT_EQ(SamplePoints(incidence, excluded, 100000).Points.size(), 100u);

  const SurfaceSamples part = SamplePoints(incidence, {}, 300);
  EXPECT_LE(part.Points.size(), 300u);
  EXPECT_GE(part.Points.size(), 255u);
  for (std::size_t i = 0; i < part.Points.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GE((part.Points[i].Position(incidence) - part.Points[j].Position(incidence)).norm(),
        part.Spacing * (1.0 - 1e-9));
    }
  }
}
