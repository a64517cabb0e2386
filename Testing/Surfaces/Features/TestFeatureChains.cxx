// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Features/FeatureChains.h"
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
/// A square of 8 x 8 cells and area 1. Its edges are as sharp as is said, in radians, those inside
/// a little bent by noise.
class SharpSquare
{
public:
  static constexpr double Angle = 0.5;
  static constexpr double Noise = 0.2;
  static constexpr double Blunt = 0.6;
  static constexpr double Clear = 1.1;

  SharpSquare()
  {
    for (std::size_t e = 0; e < this->Dihedral.size(); ++e)
    {
      this->Dihedral[e] = e % 2 != 0 ? Noise : -Noise;
    }
  }
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

TEST(FeatureChains, ShortOnesAreNoise)
{
  SharpSquare square;
  square.Sharpen({ { 2, 4 }, { 3, 4 }, { 4, 4 }, { 5, 4 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(0.0), 3);
  EXPECT_EQ(square.CountFeatures(0.37), 3);
  EXPECT_EQ(square.CountFeatures(0.38), 0);
  // From the boundary to nowhere.
  square.Sharpen({ { 8, 2 }, { 7, 2 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(0.3), 3);
}

TEST(FeatureChains, GrowTogetherWhereBranchesAreDropped)
{
  // The pieces between the branches are too short, and so are the ends; what becomes of the pieces
  // is not.
  SharpSquare square;
  square.Sharpen(
    { { 1, 4 }, { 2, 4 }, { 3, 4 }, { 4, 4 }, { 5, 4 }, { 6, 4 }, { 7, 4 } }, SharpSquare::Blunt);
  for (const int x : { 2, 3, 5 })
  {
    square.Sharpen({ { x, 4 }, { x, 5 } }, SharpSquare::Blunt);
  }
  EXPECT_EQ(square.CountFeatures(0.0), 9);
  EXPECT_EQ(square.CountFeatures(0.3), 3);
  EXPECT_EQ(square.CountFeatures(0.4), 0);
}

TEST(FeatureChains, WhatStandsOutIsKept)
{
  // Chains that end freely, twice, and from chain to chain: how sharp the short one must be.
  const auto kept = [](double angle, bool between)
  {
    SharpSquare square;
    if (between)
    {
      square.Sharpen({ { 3, 0 }, { 3, 1 }, { 3, 2 }, { 3, 3 }, { 3, 4 }, { 3, 5 }, { 3, 6 },
                       { 3, 7 }, { 3, 8 } },
        SharpSquare::Blunt);
      square.Sharpen({ { 4, 0 }, { 4, 1 }, { 4, 2 }, { 4, 3 }, { 4, 4 }, { 4, 5 }, { 4, 6 },
                       { 4, 7 }, { 4, 8 } },
        SharpSquare::Blunt);
    }
    square.Sharpen({ { 3, 4 }, { 4, 4 } }, angle);
    return square.CountFeatures(0.45) - (between ? 16 : 0);
  };
  // A noise of 0.2: four times is 0.8, and very sharp is 60 degrees or 1.05.
  EXPECT_EQ(kept(0.75, true), 0);
  EXPECT_EQ(kept(0.85, true), 1);
  EXPECT_EQ(kept(1.0, false), 0);
  EXPECT_EQ(kept(1.1, false), 1);
}

TEST(FeatureChains, WithoutNoiseAShortEdgeStandsOut)
{
  // A fold that is one edge long and ends in the middle of a plane, nearly.
  const SurfaceGeometry geometry(Square(8));
  std::vector<double> dihedral(geometry.Mesh.GetNumberOfEdges(), 0.05);
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = geometry.Mesh.HalfEdge(e);
    if (!geometry.Mesh.IsBoundary(geometry.Mesh.Tail(h)) &&
      !geometry.Mesh.IsBoundary(geometry.Mesh.Head(h)))
    {
      std::vector<double> own = dihedral;
      own[e] = 0.55;
      EXPECT_TRUE(FeatureChains(geometry, own, { 0.5, 10.0 }).IsFeature(e));
      std::fill(own.begin(), own.end(), 0.2);
      own[e] = 0.55;
      EXPECT_FALSE(FeatureChains(geometry, own, { 0.5, 10.0 }).IsFeature(e));
    }
  }
}

TEST(FeatureChains, WhatLeadsFromBoundaryToBoundaryIsKept)
{
  SharpSquare square;
  square.Sharpen({ { 0, 2 }, { 1, 2 }, { 1, 1 }, { 1, 0 } }, SharpSquare::Blunt);
  EXPECT_EQ(square.CountFeatures(10.0), 3);
}

TEST(FeatureChains, RimsAreKeptAsChainsAre)
{
  for (const double angle : { SharpSquare::Clear, SharpSquare::Blunt })
  {
    SharpSquare square;
    square.Sharpen(
      { { 3, 3 }, { 4, 3 }, { 5, 3 }, { 5, 4 }, { 5, 5 }, { 4, 5 }, { 3, 5 }, { 3, 4 }, { 3, 3 } },
      angle);
    const Index clear = angle == SharpSquare::Clear ? 8 : 0;
    EXPECT_EQ(square.CountFeatures(0.99), 8);
    EXPECT_EQ(square.CountFeatures(1.01), clear);
    // With a spur, too.
    square.Sharpen({ { 5, 3 }, { 6, 3 } }, SharpSquare::Blunt);
    EXPECT_EQ(square.CountFeatures(1.01), clear);
  }
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
  // One at each corner, the fewest that there can be.
  EXPECT_EQ(Singular(kept), 8);
  EXPECT_GT(Singular(all), 8);
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
