// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Transfer/CarriedValues.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

using namespace DirectionFields;

namespace
{
/// A mesh of a surface, and what its faces cover.
struct Example
{
  Example(Surface&& surface, Index faces, std::vector<Index>&& regions = {})
    : Given(std::move(surface))
    , Regions(std::move(regions))
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    options.Regions = this->Regions;
    this->Mesh = Remesh(std::make_shared<Surface>(this->Given)).Compute(options);
    this->Overlaps = FindOverlaps(this->Given, this->Mesh, this->Regions);
  }
  CarriedValues Carried() const
  {
    return { this->Given, this->Mesh, this->Regions, this->Overlaps };
  }

  Surface Given;
  std::vector<Index> Regions;
  RemeshResult Mesh;
  FaceOverlaps Overlaps;
};

Vector3 MiddleOf(const Surface& surface, std::size_t t)
{
  const Triangle& corners = surface.Triangles[t];
  return (surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]]) /
    3.0;
}

double AreaOf(const Surface& surface, std::size_t t)
{
  const Triangle& c = surface.Triangles[t];
  const Vector3& a = surface.Points[c[0]];
  return 0.5 * (surface.Points[c[1]] - a).cross(surface.Points[c[2]] - a).norm();
}

/// A number at each triangle, as different as can be.
double Noise(std::size_t t)
{
  return std::sin(static_cast<double>(t * t) + 0.5);
}

template <typename Value>
std::vector<double> OnTriangles(const Surface& surface, const Value& value)
{
  std::vector<double> values;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    values.push_back(value(t));
  }
  return values;
}

/// The sum of value times area over the faces of one region.
double IntegralOver(const Example& at, const std::vector<double>& values, Index region = None)
{
  const std::vector<double> areas = CarriedValues::AreasOf(at.Mesh);
  double sum = 0.0;
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    sum += region == None || at.Mesh.Regions[f] == region ? areas[f] * values[f] : 0.0;
  }
  return sum;
}

double IntegralOver(const Surface& surface, const std::vector<double>& values)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < values.size(); ++t)
  {
    sum += AreaOf(surface, t) * values[t];
  }
  return sum;
}
}

/// Each triangle is covered once, whether faces are larger or smaller than it.
TEST(FaceOverlaps, CoverEachTriangleOnce)
{
  std::vector<Example> examples;
  examples.emplace_back(Meshes::Potato(4), 100);
  examples.emplace_back(Meshes::Square(2), 400);
  examples.emplace_back(Meshes::Cube(), 600);
  for (const Example& at : examples)
  {
    std::vector<double> covered(at.Given.Triangles.size(), 0.0);
    const double unit = at.Overlaps.Unit;
    for (std::size_t k = 0; k < at.Overlaps.Areas.size(); ++k)
    {
      covered[at.Overlaps.Triangles[k]] += at.Overlaps.Areas[k] * unit * unit;
    }
    for (std::size_t t = 0; t < covered.size(); ++t)
    {
      EXPECT_NEAR(covered[t], AreaOf(at.Given, t), 1e-12 * covered[t]);
    }
  }
}

/// On a plane a face covers its own area, but for the parts across its edges.
TEST(FaceOverlaps, HaveTheAreasOfFaces)
{
  const Example at(Meshes::Square(3), 100);
  const std::vector<double> areas = CarriedValues::AreasOf(at.Mesh);
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const double covered = std::accumulate(
      at.Overlaps.Areas.begin() + static_cast<std::ptrdiff_t>(at.Overlaps.Offsets[f]),
      at.Overlaps.Areas.begin() + static_cast<std::ptrdiff_t>(at.Overlaps.Offsets[f + 1]), 0.0);
    EXPECT_NEAR(covered * at.Overlaps.Unit * at.Overlaps.Unit, areas[f], 0.35 * areas[f]);
  }
}

/// Squares of the coordinates would overflow, or vanish: the parts are the same all the same, and so
/// are values that keep their integral.
TEST(FaceOverlaps, AreTheSameAtAnySize)
{
  const Example at(Meshes::Potato(3), 60);
  const std::vector<double> noise = OnTriangles(at.Given, Noise);
  const std::vector<double> carried = at.Carried().Conserved(noise, 1);
  for (const int exponent : { 515, -515 })
  {
    const double size = std::ldexp(1.0, exponent);
    Example other = at;
    for (std::vector<Vector3>* const points : { &other.Given.Points, &other.Mesh.Points })
    {
      for (Vector3& point : *points)
      {
        point *= size;
      }
    }
    other.Mesh.EdgeLength *= size;
    other.Overlaps = FindOverlaps(other.Given, other.Mesh);
    EXPECT_EQ(other.Overlaps.Unit, size * at.Overlaps.Unit);
    EXPECT_EQ(other.Overlaps.Offsets, at.Overlaps.Offsets);
    EXPECT_EQ(other.Overlaps.Triangles, at.Overlaps.Triangles);
    EXPECT_EQ(other.Overlaps.Areas, at.Overlaps.Areas);
    EXPECT_EQ(other.Carried().Conserved(noise, 1), carried);
  }
}

/// A constant stays what it is, and a mean is between the values that it is of.
TEST(CarriedValues, AreMeans)
{
  const Example at(Meshes::Potato(4), 200);
  const CarriedValues carried = at.Carried();
  for (const double value :
    carried.Means(OnTriangles(at.Given, [](std::size_t) { return 0.1; }), 1))
  {
    EXPECT_EQ(value, 0.1);
  }
  const auto height = [&](std::size_t t) { return MiddleOf(at.Given, t).z(); };
  const std::vector<double> means = carried.Means(OnTriangles(at.Given, height), 1);
  for (std::size_t f = 0; f < means.size(); ++f)
  {
    double sum = 0.0;
    for (int c = 0; c < 4; ++c)
    {
      const Index corner = at.Mesh.Faces[f][c] == None ? at.Mesh.Faces[f][0] : at.Mesh.Faces[f][c];
      sum += at.Mesh.Points[corner].z() / 4.0;
    }
    EXPECT_NEAR(means[f], sum, 0.2 * at.Mesh.EdgeLength);
  }
}

/// Places without a value stay few: they are left out, unless they are most of a face.
TEST(CarriedValues, LeaveOutWhatIsNoNumber)
{
  const Example at(Meshes::Square(40), 100);
  const auto value = [&](std::size_t t)
  { return MiddleOf(at.Given, t).x() < 0.5 || t % 4 == 0 ? std::nan("") : 2.0; };
  const std::vector<double> means = at.Carried().Means(OnTriangles(at.Given, value), 1);
  for (std::size_t f = 0; f < means.size(); ++f)
  {
    const double x = MiddleOf(at.Given, at.Mesh.FaceSource[f]).x();
    EXPECT_TRUE(x > 0.55 ? means[f] == 2.0 : x > 0.45 || std::isnan(means[f]));
  }
}

/// The integral is kept, of noise, of a peak that is smaller than a face, and of each component.
TEST(CarriedValues, KeepTheIntegral)
{
  const Example at(Meshes::Potato(4), 150);
  const auto noise = [](std::size_t t) { return Noise(t); };
  const auto peak = [](std::size_t t) { return t == 77 ? 1000.0 : 0.0; };
  std::vector<double> both;
  for (std::size_t t = 0; t < at.Given.Triangles.size(); ++t)
  {
    both.push_back(noise(t));
    both.push_back(peak(t));
  }
  double change = -1.0;
  const std::vector<double> carried = at.Carried().Conserved(both, 2, &change);
  EXPECT_GE(change, 0.0);
  EXPECT_LT(change, 0.1);
  for (int c = 0; c < 2; ++c)
  {
    std::vector<double> given;
    std::vector<double> got;
    std::vector<double> sizes;
    for (std::size_t k = c; k < both.size(); k += 2)
    {
      given.push_back(both[k]);
      sizes.push_back(std::abs(both[k]));
    }
    for (std::size_t k = c; k < carried.size(); k += 2)
    {
      got.push_back(carried[k]);
    }
    EXPECT_NEAR(
      IntegralOver(at, got), IntegralOver(at.Given, given), 1e-12 * IntegralOver(at.Given, sizes));
  }
  // Where nothing was there is nothing.
  const std::vector<double> single = at.Carried().Conserved(OnTriangles(at.Given, peak), 1);
  EXPECT_LE(std::count_if(single.begin(), single.end(), [](double v) { return v != 0.0; }), 4);
  EXPECT_GE(*std::min_element(single.begin(), single.end()), 0.0);
}

/// Halves of a square with other loads: each keeps its own, and no value crosses the border.
TEST(CarriedValues, KeepToTheirRegions)
{
  Surface square = Meshes::Square(8);
  std::vector<Index> regions;
  for (std::size_t t = 0; t < square.Triangles.size(); ++t)
  {
    regions.push_back(MiddleOf(square, t).x() < 0.5 ? 3 : 9);
  }
  const Example at(std::move(square), 30, std::move(regions));
  ASSERT_EQ(at.Mesh.RegionsShown.Regions, 2);
  const std::vector<double> values = OnTriangles(
    at.Given, [&](std::size_t t) { return (at.Regions[t] == 3 ? 2.0 : -9.0) + Noise(t); });
  const std::vector<double> carried = at.Carried().Conserved(values, 1);
  for (const Index region : { 3, 9 })
  {
    std::vector<double> own = values;
    for (std::size_t t = 0; t < own.size(); ++t)
    {
      own[t] = at.Regions[t] == region ? own[t] : 0.0;
    }
    EXPECT_NEAR(IntegralOver(at, carried, region), IntegralOver(at.Given, own), 1e-12);
  }
  const std::vector<double> means = at.Carried().Means(values, 1);
  for (std::size_t f = 0; f < means.size(); ++f)
  {
    EXPECT_EQ(means[f] > 0.0, at.Mesh.Regions[f] == 3);
  }
}

/// A face has the number that covers most of it, not that at its middle.
TEST(CarriedValues, AreThoseOfTheLargestOverlap)
{
  const Example at(Meshes::Square(60), 36);
  // A stripe over a fifth of a face, at its middle.
  std::vector<Index> classes;
  for (std::size_t t = 0; t < at.Given.Triangles.size(); ++t)
  {
    const double x = 6.0 * MiddleOf(at.Given, t).x();
    classes.push_back(std::abs(x - std::floor(x) - 0.5) < 0.1 ? 1 : 2);
  }
  for (const Index t : at.Carried().LargestOverlaps(classes))
  {
    EXPECT_EQ(classes[t], 2);
  }
  // Where all values differ a triangle of the face itself is taken.
  std::iota(classes.begin(), classes.end(), 0);
  const std::vector<Index> triangles = at.Carried().LargestOverlaps(classes);
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    const auto begin = at.Overlaps.Triangles.begin();
    EXPECT_TRUE(std::binary_search(begin + static_cast<std::ptrdiff_t>(at.Overlaps.Offsets[f]),
      begin + static_cast<std::ptrdiff_t>(at.Overlaps.Offsets[f + 1]), triangles[f]));
  }
}

/// The sides of a shell that is thinner than its faces bend keep their values.
TEST(CarriedValues, KeepToTheirSideOfAShell)
{
  const Surface outside = Meshes::Icosphere(3);
  const auto half = static_cast<std::size_t>(outside.Triangles.size());
  // The mirrored sphere looks inward.
  const Example at(
    Meshes::Joined(
      outside, Meshes::Transformed(outside, -0.99 * Eigen::Matrix3d::Identity(), Vector3::Zero())),
    200);
  EXPECT_GT(at.Mesh.MaximumDistance, 0.01);
  const std::vector<double> means = at.Carried().Means(
    OnTriangles(at.Given, [&](std::size_t t) { return t < half ? 1.0 : -1.0; }), 1);
  for (std::size_t f = 0; f < means.size(); ++f)
  {
    const std::array<Index, 4>& face = at.Mesh.Faces[f];
    const Vector3& a = at.Mesh.Points[face[0]];
    const double side = (at.Mesh.Points[face[1]] - a).cross(at.Mesh.Points[face[2]] - a).dot(a);
    EXPECT_EQ(means[f], side > 0.0 ? 1.0 : -1.0);
  }
}
