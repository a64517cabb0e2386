// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/FieldMatching.h"
#include "Meshes/Surfaces.h"
#include "Preparation/FeatureTurns.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// The points where the boundary of a surface turns, seen over a length.
std::vector<Vector3> TurnsOf(const Surface& surface, double length, Index alsoEnd = None)
{
  const SurfaceGeometry geometry(surface);
  const std::vector<Complex> section(geometry.Mesh.GetNumberOfVertices(), Complex(1.0, 0.0));
  const FieldMatching charts(geometry, 4, section);
  const std::vector<char> isFrameless = FramelessVertices(geometry, 4, {});
  FeatureLines features(geometry, charts, {}, isFrameless, { length });
  if (alsoEnd != None)
  {
    features.IsEnd.assign(geometry.Mesh.GetNumberOfVertices(), 0);
    features.IsEnd[alsoEnd] = 1;
  }
  const std::vector<char> isTurn =
    FindTurns(geometry, features, std::vector<double>(section.size(), length));
  std::vector<Vector3> turns;
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    if (isTurn[v] != 0)
    {
      turns.push_back(geometry.Positions[v]);
    }
  }
  return turns;
}
}

TEST(FeatureTurns, AreTheCornersOfTheShape)
{
  // Each of a square's corners, and all six of an L, also the one that is not convex; none of a round boundary.
  for (const double length : { 0.05, 0.2 })
  {
    const std::vector<Vector3> turns = TurnsOf(Meshes::Square(10), length);
    ASSERT_EQ(turns.size(), 4u);
    for (const Vector3& p : turns)
    {
      EXPECT_NEAR(std::abs(p[0] - 0.5) + std::abs(p[1] - 0.5), 1.0, 1e-12);
    }
    EXPECT_EQ(TurnsOf(Meshes::LShape(10), length).size(), 6u);
    EXPECT_TRUE(TurnsOf(Meshes::Disk(20), length).empty());
  }
  // So is where the caller says that a feature ends.
  EXPECT_EQ(TurnsOf(Meshes::Disk(20), 0.1, SurfaceGeometry(Meshes::Disk(20)).Mesh.Head(0)).size() +
      TurnsOf(Meshes::Disk(20), 0.1).size(),
    1u);
}

TEST(FeatureTurns, AreNotTheTeethOfAJaggedBoundary)
{
  // Each second vertex of the upper side is more than half an edge higher: it turns by more than 60 degrees at each
  // vertex, but by little over many.
  Surface jagged = Meshes::Square(20);
  for (Vector3& p : jagged.Points)
  {
    const auto column = std::lround(p[0] * 20.0);
    p[1] += p[1] > 0.999 && column % 2 == 1 ? 0.03 : 0.0;
  }
  EXPECT_GT(TurnsOf(jagged, 0.02).size(), 20u);
  EXPECT_EQ(TurnsOf(jagged, 0.4).size(), 4u);
}
