// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Field/FeatureChains.h"
#include "Geometry/DihedralAngles.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;
using namespace Meshes;

namespace
{
/// A square of 8 x 8 cells and area 1 whose edges are as sharp as is said, in radians.
class SharpSquare
{
public:
  static constexpr double Angle = 0.5;
  static constexpr double Blunt = 0.6;
  static constexpr double VerySharp = 1.2;

  void Sharpen(const std::vector<std::pair<int, int>>& places, double angle)
  {
    for (std::size_t k = 1; k < places.size(); ++k)
    {
      this->Dihedral[this->EdgeBetween(places[k - 1], places[k])] = angle;
    }
  }
  Index CountFeatures(double minimumLength) const
  {
    const FeatureChains chains(this->Geometry, this->Dihedral, { Angle, minimumLength });
    Index features = 0;
    for (Index e = 0; e < this->Geometry.Mesh.GetNumberOfEdges(); ++e)
    {
      features += chains.IsFeature(e);
    }
    return features;
  }

private:
  Index EdgeBetween(const std::pair<int, int>& from, const std::pair<int, int>& to) const
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    const auto point = [](const std::pair<int, int>& place)
    { return 9 * place.second + place.first; };
    for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      if (mesh.Point(mesh.Tail(h)) == point(from) && mesh.Point(mesh.Head(h)) == point(to))
      {
        return mesh.Edge(h);
      }
    }
    ADD_FAILURE() << "no such edge";
    return 0;
  }

  SurfaceGeometry Geometry{ Square(8) };
  std::vector<double> Dihedral = std::vector<double>(this->Geometry.Mesh.GetNumberOfEdges(), 0.0);
};

using Places = std::vector<std::pair<int, int>>;

Options Sharp(double minimumLength)
{
  Options options;
  options.ConstrainSharpEdges = true;
  options.MinimumFeatureLength = minimumLength;
  return options;
}

Index Singular(const Result& result)
{
  return static_cast<Index>(result.SingularityIndex.size() -
    std::count(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0));
}
}

TEST(FeatureChains, ShortOnesThatEndFreelyAreNoise)
{
  SharpSquare square;
  square.Sharpen({ { 2, 4 }, { 3, 4 }, { 4, 4 }, { 5, 4 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(0.0), 3);
  EXPECT_EQ(square.CountFeatures(0.37), 3);
  EXPECT_EQ(square.CountFeatures(0.38), 0);
  // One edge more, and a short branch in the middle, which is dropped alone.
  square.Sharpen({ { 5, 4 }, { 6, 4 } }, SharpSquare::Blunt);
  square.Sharpen({ { 4, 4 }, { 4, 5 }, { 4, 6 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(0.2), 6);
  EXPECT_EQ(square.CountFeatures(0.0), 6);
}

TEST(FeatureChains, ABranchLessMakesAChainOfTwo)
{
  // Each side of the branch is shorter than wanted, both together are not, and lead to the boundary.
  SharpSquare square;
  square.Sharpen(
    { { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 }, { 4, 4 }, { 5, 4 }, { 6, 4 }, { 7, 4 }, { 8, 4 } },
    SharpSquare::Blunt);
  square.Sharpen({ { 4, 4 }, { 4, 5 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(0.9), 8);
}

TEST(FeatureChains, VerySharpOnesAreKept)
{
  SharpSquare square;
  square.Sharpen({ { 2, 4 }, { 3, 4 } }, SharpSquare::VerySharp);
  EXPECT_EQ(square.CountFeatures(10.0), 1);
  // In the mean.
  square.Sharpen({ { 3, 4 }, { 4, 4 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(10.0), 0);
}

TEST(FeatureChains, WhatLeadsFromBoundaryToBoundaryIsKept)
{
  SharpSquare square;
  square.Sharpen({ { 0, 2 }, { 1, 2 }, { 1, 1 }, { 1, 0 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(10.0), 3);
  // From the boundary to nowhere.
  square.Sharpen({ { 8, 4 }, { 7, 4 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(10.0), 3);
}

TEST(FeatureChains, RimsAreKept)
{
  SharpSquare square;
  square.Sharpen(
    { { 3, 3 }, { 4, 3 }, { 5, 3 }, { 5, 4 }, { 5, 5 }, { 4, 5 }, { 3, 5 }, { 3, 4 }, { 3, 3 } },
    SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(10.0), 8);
  // With a spur, too.
  square.Sharpen({ { 5, 3 }, { 6, 3 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(10.0), 8);
  // What noise makes around a vertex is no rim.
  SharpSquare spike;
  spike.Sharpen(
    { { 3, 3 }, { 4, 3 }, { 5, 4 }, { 5, 5 }, { 4, 5 }, { 3, 4 }, { 3, 3 } }, SharpSquare::Blunt);
  EXPECT_EQ(spike.CountFeatures(0.0), 6);
  EXPECT_EQ(spike.CountFeatures(10.0), 0);
}

TEST(FeatureChains, PartsKeepAllTheirEdges)
{
  // A small box beside a large part has its own size.
  const Surface beside = Joined(FlatlySubdivided(Cube(), 3),
    Transformed(ChamferedCube(4), 0.01 * Eigen::Matrix3d::Identity(), { 5, 0, 0 }));
  for (const Surface& surface : { FlatlySubdivided(Cube(), 3), ChamferedCube(8), ChamferedCube(30),
         FlatlySubdivided(Icosahedron(), 3), DoubleTorus(), FlatlySubdivided(Tetrahedron(), 4),
         Folded(Square(16), 0.8), beside })
  {
    const Result all = DirectionField(surface).Compute(Sharp(0.0));
    const Result kept = DirectionField(surface).Compute(Sharp(Options().MinimumFeatureLength));
    EXPECT_GT(Count(all, ConstraintKind::SharpEdge), 0);
    EXPECT_EQ(kept.Constraint, all.Constraint);
    EXPECT_EQ(kept.Representation, all.Representation);
  }
}

TEST(FeatureChains, NoiseOfASmoothBodyIsDropped)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const Surface noisy = Jittered(Potato(5), 0.012, seed);
    const Result all = DirectionField(noisy).Compute(Sharp(0.0));
    const Result kept = DirectionField(noisy).Compute(Sharp(Options().MinimumFeatureLength));
    EXPECT_GT(Count(all, ConstraintKind::SharpEdge), 200);
    EXPECT_LE(2 * Singular(kept), Singular(all));
  }
}

TEST(FeatureChains, NoiseOfAPartIsDroppedAndItsEdgesAreNot)
{
  // A cube of side 1 whose edges have 32 pieces.
  const Surface cube = FlatlySubdivided(Cube(), 5);
  Vector3 low = cube.Points[0];
  Vector3 high = low;
  for (const Vector3& p : cube.Points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double piece = (high.x() - low.x()) / 32.0;
  const Surface noisy = Jittered(cube, 0.25 * piece, 5);
  const Result all = DirectionField(noisy).Compute(Sharp(0.0));
  const Result kept = DirectionField(noisy).Compute(Sharp(Options().MinimumFeatureLength));
  EXPECT_LE(2 * Singular(kept), Singular(all));
  for (std::size_t i = 0; i < cube.Points.size(); ++i)
  {
    int sides = 0;
    for (int k = 0; k < 3; ++k)
    {
      sides += cube.Points[i][k] == low[k] || cube.Points[i][k] == high[k];
    }
    if (sides >= 2)
    {
      EXPECT_EQ(kept.Constraint[i], ConstraintKind::SharpEdge);
    }
  }
}
