// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/Apices.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr int Around = 48;
constexpr int Along = 40;

/// A cone of radius 1, open below, of rings of triangles; point 0 is its tip.
Surface RingedCone(double height)
{
  Surface cone;
  cone.Points.emplace_back(0.0, 0.0, height);
  for (int r = 1; r <= Along; ++r)
  {
    for (int k = 0; k < Around; ++k)
    {
      const double radius = static_cast<double>(r) / Along;
      const double angle = 2.0 * Pi * k / Around;
      cone.Points.emplace_back(
        radius * std::cos(angle), radius * std::sin(angle), height * (1.0 - radius));
    }
  }
  for (int k = 0; k < Around; ++k)
  {
    const int next = (k + 1) % Around;
    cone.Triangles.push_back({ 0, 1 + k, 1 + next });
    for (int r = 0; r + 1 < Along; ++r)
    {
      const Index a = 1 + r * Around + k;
      const Index b = 1 + r * Around + next;
      cone.Triangles.push_back({ a, a + Around, b + Around });
      cone.Triangles.push_back({ a, b + Around, b });
    }
  }
  return cone;
}

std::vector<Index> ApicesOf(const Surface& surface, double edgeLength)
{
  return Apices(std::make_shared<Surface>(surface))
    .For(std::vector<double>(surface.Points.size(), 1.0), edgeLength);
}

double DistanceTo(const RemeshResult& mesh, const Vector3& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& p : mesh.Points)
  {
    least = std::min(least, (p - place).norm());
  }
  return least;
}
}

TEST(Apices, AreTipsOfConesMoreBentThanTheCornerOfACube)
{
  // The angles at the tip of a cone sum up to 2 pi times the sine of half its opening angle.
  for (const double height : { 0.5, 1.0, 1.2, 2.0, 5.0, -2.0 })
  {
    const double sine = 1.0 / std::hypot(1.0, height);
    const bool isTip = 2.0 * Pi * (1.0 - sine) > 100.0 / 180.0 * Pi;
    EXPECT_EQ(
      ApicesOf(RingedCone(height), 0.1), isTip ? std::vector<Index>{ 0 } : std::vector<Index>{})
      << height;
  }
  // Not so near the boundary that there is no room for a face.
  EXPECT_TRUE(ApicesOf(RingedCone(2.0), 2.5).empty());
  EXPECT_TRUE(ApicesOf(Meshes::Cylinder(20, 20, 2.0), 0.2).empty());
  EXPECT_TRUE(ApicesOf(Meshes::Disk(20), 0.2).empty());
}

TEST(Apices, AreNoBumpsSmallerThanFacesAndNoNoise)
{
  Surface disk = Meshes::Disk(40);
  // One point out of its plane by the length of its edges.
  std::size_t inner = 0;
  for (std::size_t p = 0; p < disk.Points.size(); ++p)
  {
    const Vector3 place(0.3, 0.1, 0.0);
    inner = (disk.Points[p] - place).norm() < (disk.Points[inner] - place).norm() ? p : inner;
  }
  disk.Points[inner].z() = 0.08;
  EXPECT_TRUE(ApicesOf(disk, 0.1).empty());
  EXPECT_TRUE(ApicesOf(disk, 0.2).empty());
  Surface noisy = RingedCone(2.0);
  for (std::size_t p = 1; p < noisy.Points.size(); ++p)
  {
    noisy.Points[p] += 0.03 * Vector3(std::sin(7.1 * p), std::sin(5.3 * p), std::sin(3.7 * p));
  }
  EXPECT_TRUE(ApicesOf(noisy, 0.2).empty());
}

TEST(Apices, AreVerticesOfTheMeshWhereFeaturesAreKept)
{
  for (const double height : { 2.0, 5.0 })
  {
    const Surface cone = RingedCone(height);
    for (const Index faces : { 300, 1000 })
    {
      RemeshOptions options;
      options.NumberOfFaces = faces;
      Remesh remesh(std::make_shared<Surface>(cone));
      const RemeshResult with = remesh.Compute(options);
      EXPECT_EQ(Meshes::FlawOf(with), "");
      EXPECT_LT(DistanceTo(with, cone.Points[0]), 1e-12) << height << " " << faces;
      EXPECT_LT(with.MaximumDistanceToMesh, 0.25 * with.EdgeLength) << height << " " << faces;
      EXPECT_GT(Meshes::LeastQuality(with), 0.25) << height << " " << faces;
      EXPECT_EQ(with.Triangles, 0) << height << " " << faces;
      options.KeepFeatures = false;
      const RemeshResult without = remesh.Compute(options);
      EXPECT_GT(DistanceTo(without, cone.Points[0]), 0.1 * without.EdgeLength);
      options.KeepFeatures = true;
      EXPECT_EQ(remesh.Compute(options).Points, with.Points);
    }
  }
}

TEST(Apices, OfGivenPointsAreNoOthers)
{
  const Surface cone = RingedCone(2.0);
  RemeshOptions options;
  options.NumberOfFaces = 500;
  // Beside the tip, closer than an edge: the point that was asked for is kept.
  const Vector3 given = 0.7 * cone.Points[0] + 0.3 * cone.Points[1];
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(cone), {}, { given }).Compute(options);
  EXPECT_LT(DistanceTo(mesh, given), 1e-9);
  EXPECT_GT(DistanceTo(mesh, cone.Points[0]), 0.5 * (given - cone.Points[0]).norm());
  ASSERT_EQ(std::count_if(mesh.Chains.begin(), mesh.Chains.end(),
              [](const MeshChain& chain) { return chain.Kind == ChainKind::Point; }),
    1);
}
