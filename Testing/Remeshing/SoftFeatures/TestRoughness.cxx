// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/Roughness.h"

#include "Meshes/Surfaces.h"
#include "Preparation/PreparedField.h"
#include "Preparation/PreparedSurface.h"
#include "SoftFeatures/FeaturesInNoise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

TEST(Roughness, IsThatOfNoiseAndNotOfFacetsOrEdges)
{
  for (const Surface& smooth : { Meshes::Cube(), Meshes::Icosahedron(), Meshes::Icosphere(1),
         Meshes::Potato(3), Meshes::ChamferedCube(6), Meshes::BallWithLimbs() })
  {
    EXPECT_FALSE(IsRough(SurfaceGeometry(smooth)));
  }
  EXPECT_FALSE(IsRough(SurfaceGeometry(Meshes::Roughened(Meshes::Icosphere(3), 0.1, 7))));
  for (const double noise : { 0.5, 1.0, 2.0 })
  {
    EXPECT_TRUE(IsRough(SurfaceGeometry(Meshes::Roughened(Meshes::Icosphere(3), noise, 7))));
  }
}

TEST(Roughness, MakesNoFeaturesWhereEdgesAreSplit)
{
  constexpr FeatureSettings sharp{ true, 40.0, 0.5, 0.0 };
  const Surface surface = Meshes::Roughened(Meshes::FlatlySubdivided(Meshes::Cube(), 4), 0.4, 7);
  const SurfaceGeometry geometry(surface);
  WorkingLengths lengths;
  lengths.Face = 0.1;
  lengths.Split.assign(surface.Points.size(), 0.05);
  lengths.MostMiddles = 10000;
  // Edges that are long are split only beside a hub, for which a surface is split that is not of planes.
  const PreparedSurface whole(surface, 4, sharp, lengths);
  lengths.HasNeedles = true;
  const PreparedSurface prepared(surface, 4, sharp, lengths);
  EXPECT_TRUE(prepared.IsRough());
  const Index before = geometry.Mesh.GetNumberOfTriangles();
  EXPECT_LT(whole.GetGeometry().Mesh.GetNumberOfTriangles(), 2 * before);
  EXPECT_GT(prepared.GetGeometry().Mesh.GetNumberOfTriangles(), 2 * before);
  const auto lengthOf = [](const SurfaceGeometry& of, const std::vector<Vector3>& positions,
                          const std::vector<char>& isFeature)
  {
    double length = 0.0;
    for (std::size_t e = 0; e < isFeature.size(); ++e)
    {
      const Index h = of.Mesh.HalfEdge(static_cast<Index>(e));
      const Vector3 edge = positions[of.Mesh.Head(h)] - positions[of.Mesh.Tail(h)];
      length += isFeature[e] != 0 ? edge.norm() : 0.0;
    }
    return length;
  };
  const double length = lengthOf(geometry, geometry.Positions, FeaturesInNoise(geometry, sharp));
  EXPECT_GT(length, 0.0);
  EXPECT_NEAR(
    lengthOf(prepared.GetGeometry(), prepared.GetGivenPositions(), prepared.FindFeatures(sharp)),
    length, 1e-9);
}

namespace
{
/// A ball with a bump as high as its radius at each corner of an icosahedron.
Surface BallWithBumps()
{
  Surface ball = Meshes::Icosphere(4);
  const std::vector<Vector3> tips = Meshes::Icosahedron().Points;
  for (Vector3& point : ball.Points)
  {
    double radius = 1.0;
    for (const Vector3& tip : tips)
    {
      const double angle = std::acos(std::clamp(point.dot(tip.normalized()), -1.0, 1.0));
      radius += std::exp(-16.0 * angle * angle);
    }
    point *= radius;
  }
  return ball;
}
}

TEST(Roughness, IsSmoothedAwayButNotBumpsThatFacesCanShow)
{
  const Surface ball = BallWithBumps();
  WorkingLengths lengths;
  lengths.Face = 0.12;
  lengths.MostNeedless = 20;
  const auto needless = [&](const Surface& surface, double& moved)
  {
    const PreparedField field(
      surface, 6, KeptEdges({ false, 40.0, 0.0, 0.0 }), lengths, {}, ShapeAlignment(), Progress());
    const std::vector<Vector3> given = field.GetSurface().GetGivenPositions();
    std::vector<double> distances;
    for (std::size_t v = 0; v < given.size(); ++v)
    {
      distances.push_back((given[v] - field.GetGeometry().Positions[v]).norm());
    }
    std::sort(distances.begin(), distances.end());
    moved = distances[distances.size() * 95 / 100];
    return field.GetNeedless();
  };
  double moved = 0.0;
  // Four steps move it by less than a face, and sixteen more by up to a third of its radius.
  EXPECT_GT(needless(ball, moved), 20);
  EXPECT_LT(moved, lengths.Face);
  EXPECT_GT(needless(Meshes::Roughened(Meshes::Icosphere(4), 1.0, 7), moved), 20);
  EXPECT_GT(moved, 0.05);
}
