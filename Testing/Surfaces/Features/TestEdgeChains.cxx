// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/EdgeChains.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace DirectionFields;

namespace
{
/// Not 0 for the edges whose ends both satisfy a condition.
std::vector<char> Marked(
  const SurfaceGeometry& geometry, const std::function<bool(const Vector3&)>& holds)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<char> isMarked(mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    isMarked[e] =
      holds(geometry.Positions[mesh.Tail(h)]) && holds(geometry.Positions[mesh.Head(h)]) ? 1 : 0;
  }
  return isMarked;
}

bool Is(double a, double b)
{
  return std::abs(a - b) < 1e-9;
}
}

TEST(EdgeChains, EndWhereTheyMeetAndOnTheBoundary)
{
  const SurfaceGeometry square(Meshes::Square(10));
  // A line from side to side, and one that leaves it in its middle and ends inside.
  std::vector<char> isMarked = Marked(square, [](const Vector3& p) { return Is(p.y(), 0.5); });
  const std::vector<char> leaves =
    Marked(square, [](const Vector3& p) { return Is(p.x(), 0.5) && p.y() > 0.49 && p.y() < 0.85; });
  std::transform(isMarked.begin(), isMarked.end(), leaves.begin(), isMarked.begin(),
    [](char a, char b) { return a != 0 || b != 0 ? 1 : 0; });
  std::vector<EdgeChain> chains = ChainsOf(square.Mesh, isMarked);
  ASSERT_EQ(chains.size(), 3);
  std::sort(chains.begin(), chains.end(),
    [](const EdgeChain& a, const EdgeChain& b) { return a.Edges.size() < b.Edges.size(); });
  EXPECT_EQ(chains[0].Edges.size(), 3);
  EXPECT_TRUE(chains[0].EndsFreely);
  EXPECT_NEAR(chains[0].Length(square), 0.3, 1e-12);
  for (int k = 1; k < 3; ++k)
  {
    EXPECT_EQ(chains[k].Edges.size(), 5);
    EXPECT_EQ(chains[k].Vertices.size(), 6);
    EXPECT_FALSE(chains[k].EndsFreely);
    EXPECT_FALSE(chains[k].IsClosed);
  }
}

TEST(EdgeChains, ClosedOnesComeBackToTheirFirstVertex)
{
  constexpr int around = 24;
  const SurfaceGeometry cylinder(Meshes::Cylinder(around, 4, 2.0));
  const std::vector<EdgeChain> chains =
    ChainsOf(cylinder.Mesh, Marked(cylinder, [](const Vector3& p) { return Is(p.z(), 1.0); }));
  ASSERT_EQ(chains.size(), 1);
  EXPECT_TRUE(chains[0].IsClosed);
  EXPECT_FALSE(chains[0].EndsFreely);
  EXPECT_EQ(chains[0].Edges.size(), around);
  EXPECT_EQ(chains[0].Vertices.front(), chains[0].Vertices.back());
  EXPECT_NEAR(chains[0].Length(cylinder), 2.0 * around * std::sin(Pi / around), 1e-12);
}
