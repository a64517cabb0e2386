// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/BorderSizes.h"

#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// A square of 2 by 2 around the origin in two regions, the inner one a disk of a radius whose
/// border has a number of edges. Points on rays, as many as that number.
Surface SquareWithDisk(double radius, Index around, std::vector<Index>& regions)
{
  constexpr Index inner = 4;
  constexpr Index outer = 12;
  Surface surface;
  surface.Points.emplace_back(0.0, 0.0, 0.0);
  regions.clear();
  for (Index ring = 1; ring <= inner + outer; ++ring)
  {
    for (Index k = 0; k < around; ++k)
    {
      const double angle = 2.0 * Pi * static_cast<double>(k) / static_cast<double>(around);
      const Vector3 ray(std::cos(angle), std::sin(angle), 0.0);
      const Vector3 onSquare = ray / ray.lpNorm<Eigen::Infinity>();
      const double part = static_cast<double>(ring - inner) / outer;
      surface.Points.push_back(ring <= inner
          ? Vector3(radius * static_cast<double>(ring) / inner * ray)
          : Vector3((1.0 - part) * radius * ray + part * onSquare));
    }
  }
  const auto at = [&](Index ring, Index k) { return 1 + (ring - 1) * around + k % around; };
  for (Index k = 0; k < around; ++k)
  {
    surface.Triangles.push_back({ 0, at(1, k), at(1, k + 1) });
    regions.push_back(0);
    for (Index ring = 1; ring < inner + outer; ++ring)
    {
      surface.Triangles.push_back({ at(ring, k), at(ring + 1, k), at(ring + 1, k + 1) });
      surface.Triangles.push_back({ at(ring, k), at(ring + 1, k + 1), at(ring, k + 1) });
      regions.insert(regions.end(), 2, ring < inner ? 0 : 1);
    }
  }
  return surface;
}

double LeastOf(const std::vector<double>& lengths)
{
  return *std::min_element(lengths.begin(), lengths.end());
}
}

/// A chord of length l of a circle of radius r is l^2 / 8 r from it. The tolerance is .00085 of
/// the diagonal, less what the input's own chords are away.
TEST(BorderSizes, AreThoseOfTheCircle)
{
  std::vector<Index> regions;
  constexpr double radius = 0.2;
  for (const Index around : { 32, 64 })
  {
    const Surface surface = SquareWithDisk(radius, around, regions);
    const double tolerance = 0.85e-3 * std::sqrt(8.0);
    const double own = radius * (1.0 - std::cos(Pi / static_cast<double>(around)));
    const double longest = std::sqrt(8.0 * radius * (tolerance - own));
    for (const double wanted : { 1.1 * longest, 1.5 * longest })
    {
      const std::vector<double> lengths = LengthsAtBorders(surface, regions, wanted);
      ASSERT_EQ(lengths.size(), surface.Points.size());
      EXPECT_NEAR(LeastOf(lengths), longest, 0.02 * longest) << around;
      EXPECT_TRUE(std::isinf(lengths.back()));
      // Lengths grow by a quarter of the way.
      for (const Triangle& t : surface.Triangles)
      {
        for (int c = 0; c < 3; ++c)
        {
          const Index p = t[c];
          const Index q = t[(c + 1) % 3];
          EXPECT_LE(std::min(lengths[q], wanted),
            lengths[p] + 0.26 * (surface.Points[q] - surface.Points[p]).norm());
        }
      }
    }
    // Edges that are short already, or would have to be far shorter, stay.
    EXPECT_TRUE(LengthsAtBorders(surface, regions, 0.95 * longest).empty());
    EXPECT_TRUE(LengthsAtBorders(surface, regions, 2.0 * longest).empty());
    EXPECT_TRUE(LengthsAtBorders(surface, {}, 1.5 * longest).empty());
    const std::vector<double> ofSoup =
      LengthsAtBorders(Meshes::Soup(surface), regions, 1.5 * longest);
    ASSERT_FALSE(ofSoup.empty());
    EXPECT_NEAR(LeastOf(ofSoup), longest, 0.02 * longest);
  }
}

/// Stairs and corners are no arcs: a border along the edges of a grid has lengths of its own
/// nowhere.
TEST(BorderSizes, CornersAreNoArcs)
{
  const Surface square = Meshes::Square(16);
  std::vector<Index> regions;
  for (const Triangle& t : square.Triangles)
  {
    const Vector3 middle = (square.Points[t[0]] + square.Points[t[1]] + square.Points[t[2]]) / 3.0;
    regions.push_back(middle[0] < 0.5 && middle[1] < 0.5 ? 1 : 0);
  }
  for (const double wanted : { 0.02, 0.1, 0.5 })
  {
    EXPECT_TRUE(LengthsAtBorders(square, regions, wanted).empty());
  }
}

/// The circle is within a thousandth of the diagonal from the mesh, which it is not with edges as
/// long as elsewhere.
TEST(BorderSizes, BringTheMeshToTheCircle)
{
  std::vector<Index> regions;
  constexpr double radius = 0.2;
  const auto surface = std::make_shared<Surface>(SquareWithDisk(radius, 48, regions));
  RemeshOptions options;
  options.NumberOfFaces = 500;
  options.Regions = regions;
  const auto farthest = [&]
  {
    const RemeshResult mesh = Remesh(surface).Compute(options);
    double least = radius;
    for (const MeshChain& chain : mesh.Chains)
    {
      for (std::size_t k = 0; chain.Kind == ChainKind::Border && k + 1 < chain.Points.size(); ++k)
      {
        least = std::min(
          least, (0.5 * (mesh.Points[chain.Points[k]] + mesh.Points[chain.Points[k + 1]])).norm());
      }
    }
    return (radius - least) / std::sqrt(8.0);
  };
  EXPECT_LT(farthest(), 1e-3);
  options.KeepThinParts = false;
  EXPECT_GT(farthest(), 1e-3);
}
