// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/FeaturesInNoise.h"

#include "Charts/FeatureLines.h"
#include "Geometry/DihedralAngles.h"
#include "Meshes/Surfaces.h"
#include "Preparation/PreparedSurface.h"
#include "Refinement/SmoothedPoints.h"
#include "SoftFeatures/Roughness.h"
#include "Support/SortedEnds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr FeatureSettings Sharp{ true, 40.0, 0.5, 0.0 };

std::array<Index, 2> PointsOf(const TriangleMesh& mesh, Index e)
{
  const Index h = mesh.HalfEdge(e);
  return SortedEnds(mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)));
}

/// The length of marked edges, and of those that are edges of the shape without noise.
struct Lengths
{
  Lengths(
    const SurfaceGeometry& shape, const SurfaceGeometry& noisy, const std::vector<char>& isFeature)
  {
    const std::vector<double> dihedral = DihedralAngles(shape);
    std::set<std::array<Index, 2>> features;
    for (Index e = 0; e < noisy.Mesh.GetNumberOfEdges(); ++e)
    {
      if (isFeature[e] != 0)
      {
        features.insert(PointsOf(noisy.Mesh, e));
      }
    }
    for (Index e = 0; e < shape.Mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = shape.Mesh.HalfEdge(e);
      const double length =
        (shape.Positions[shape.Mesh.Head(h)] - shape.Positions[shape.Mesh.Tail(h)]).norm();
      const bool isOfShape = std::abs(dihedral[e]) > 1.0;
      this->All += isOfShape ? length : 0.0;
      const bool isFound = features.count(PointsOf(shape.Mesh, e)) > 0;
      this->Found += isFound ? length : 0.0;
      this->Right += isFound && isOfShape ? length : 0.0;
    }
  }
  double All = 0.0;
  double Found = 0.0;
  double Right = 0.0;
};
}

TEST(FeaturesInNoise, AreThoseOfTheShape)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 4);
  const SurfaceGeometry shape(cube);
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    const SurfaceGeometry noisy(Meshes::Roughened(cube, 0.3, seed));
    ASSERT_TRUE(HasNoise(noisy));
    const Lengths found(shape, noisy, FeaturesInNoise(noisy, Sharp));
    EXPECT_GT(found.Right, 0.5 * found.All);
    EXPECT_GT(found.Right, 0.75 * found.Found);
    const Lengths byAngle(shape, noisy, FindFeatures(noisy, Sharp));
    EXPECT_LT(byAngle.Right, 0.2 * found.All);
  }
}

TEST(FeaturesInNoise, AreNoneOnRoundBodies)
{
  Index byAngle = 0;
  const Surface thin = Meshes::Torus(60, 10, 1.0, 0.2);
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    for (const Surface& body : { Meshes::Icosphere(4), thin })
    {
      const SurfaceGeometry geometry(Meshes::Roughened(body, 0.3, seed));
      ASSERT_TRUE(HasNoise(geometry));
      const std::vector<char> isFeature = FeaturesInNoise(geometry, Sharp);
      EXPECT_EQ(std::count(isFeature.begin(), isFeature.end(), 1), 0);
      const std::vector<char> simple = FindFeatures(geometry, Sharp);
      byAngle += static_cast<Index>(std::count(simple.begin(), simple.end(), 1));
    }
  }
  EXPECT_GT(byAngle, 0);
}

TEST(FeaturesInNoise, AreLookedForInNoiseAlone)
{
  for (const Surface& smooth : { Meshes::Cube(), Meshes::Potato(3), Meshes::ChamferedCube(6),
         Meshes::BallWithLimbs(), Meshes::Flange(6) })
  {
    EXPECT_FALSE(HasNoise(SurfaceGeometry(smooth)));
  }
}

TEST(FeaturesInNoise, AreSmoothLines)
{
  const Surface cube = Meshes::Roughened(Meshes::FlatlySubdivided(Meshes::Cube(), 4), 0.3, 1);
  const SurfaceGeometry noisy(cube);
  const PreparedSurface prepared(cube, 4, Sharp);
  EXPECT_TRUE(prepared.AreFeaturesInNoise());
  const auto countCorners = [](const SurfaceGeometry& geometry, const std::vector<char>& isFeature)
  {
    const std::vector<char> isFrameless = FramelessVertices(geometry, 4, isFeature);
    return std::count(isFrameless.begin(), isFrameless.end(), 1);
  };
  // They turn to and fro by more than half a right angle where noise is.
  EXPECT_GT(countCorners(noisy, FeaturesInNoise(noisy, Sharp)), 40);
  EXPECT_LT(countCorners(prepared.GetGeometry(), prepared.FindFeatures(Sharp)), 30);
  // What is meshed is the surface with its noise.
  const std::vector<ClosestPoints::Corners> given = prepared.GetGivenTriangles();
  for (std::size_t t = 0; t < given.size(); ++t)
  {
    EXPECT_EQ(given[t][0], cube.Points[prepared.GetUsedTriangles()[t][0]]);
  }
}

TEST(FeaturesInNoise, LeaveHardEdgesWhereTheyAre)
{
  const Surface square = Meshes::Jittered(Meshes::Square(8), 0.03, 5);
  const SurfaceGeometry geometry(square);
  std::vector<char> isFeature(geometry.Mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const std::array<Index, 2> ends = PointsOf(geometry.Mesh, e);
    isFeature[e] = ends[0] / 9 == 4 && ends[1] / 9 == 4 ? 1 : 0;
  }
  const Index inside = 4 * 9 + 4;
  const std::vector<Vector3> smooth =
    WithSmoothLines(geometry.Mesh, square.Points, isFeature, {}, 1);
  EXPECT_NE(smooth[inside], square.Points[inside]);
  const Vector3 middle =
    0.5 * square.Points[inside] + 0.25 * (square.Points[inside - 1] + square.Points[inside + 1]);
  EXPECT_LT((smooth[inside] - middle).norm(), 1e-14);
  EXPECT_EQ(WithSmoothLines(geometry.Mesh, square.Points, isFeature, isFeature, 1), square.Points);
}
