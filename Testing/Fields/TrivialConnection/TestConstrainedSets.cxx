// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/ConstrainedSets.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <set>

using namespace DirectionFields;
using Components::Tested;

TEST(ConstrainedSets, AreTheConnectedPartsOfTheGivenVertices)
{
  // The ends of the middle column of a square, three vertices each, and a vertex by itself.
  constexpr int cells = 8;
  const Surface square = Meshes::Square(cells);
  std::vector<Index> given;
  int alone = 0;
  for (Index i = 0; i < static_cast<Index>(square.Points.size()); ++i)
  {
    const Vector3 cell = cells * square.Points[i];
    const bool isColumn = std::abs(cell.x() - 4.0) < 1e-9 && std::abs(cell.y() - 4.0) > 1.5;
    const bool isAlone = (cell - Vector3(1.0, 4.0, 0.0)).norm() < 1e-9;
    if (isColumn || isAlone)
    {
      given.push_back(i);
      alone += isAlone ? 1 : 0;
    }
  }
  ASSERT_EQ(given.size(), 7u);
  ASSERT_EQ(alone, 1);
  const Tested tested(square, given);
  const ConstrainedSets& sets = tested.Constrained;
  // Each column of three vertices is one unknown.
  EXPECT_EQ(sets.GivenUnknowns.size(), 3u);
  EXPECT_TRUE(std::is_sorted(sets.GivenUnknowns.begin(), sets.GivenUnknowns.end()));
  EXPECT_EQ(sets.NumberOfUnknowns, tested.Component.Vertices() - 4);
  std::set<Index> unknowns;
  std::set<Index> ofGiven;
  for (Index v = 0; v < tested.Component.Vertices(); ++v)
  {
    unknowns.insert(sets.UnknownOf(v));
    if (std::count(given.begin(), given.end(), tested.Mesh.Point(v)) > 0)
    {
      ofGiven.insert(sets.UnknownOf(v));
    }
  }
  EXPECT_EQ(static_cast<Index>(unknowns.size()), sets.NumberOfUnknowns);
  EXPECT_EQ(*unknowns.rbegin(), sets.NumberOfUnknowns - 1);
  EXPECT_EQ(std::vector<Index>(ofGiven.begin(), ofGiven.end()), sets.GivenUnknowns);
  int fixed = 0;
  for (Index e = 0; e < tested.Component.Edges(); ++e)
  {
    const Index h = tested.Mesh.HalfEdge(e);
    const bool areJoined =
      sets.UnknownOf(tested.Mesh.Tail(h)) == sets.UnknownOf(tested.Mesh.Head(h));
    EXPECT_EQ(areJoined, sets.IsFixed(e));
    fixed += sets.IsFixed(e) ? 1 : 0;
  }
  EXPECT_EQ(fixed, 4);
}

TEST(ConstrainedSets, EachVertexIsAnUnknownWhereNothingIsGiven)
{
  const Tested tested(Meshes::Disk(4));
  EXPECT_EQ(tested.Constrained.NumberOfUnknowns, tested.Component.Vertices());
  EXPECT_TRUE(tested.Constrained.GivenUnknowns.empty());
  EXPECT_EQ(tested.Constrained.UnknownOf(5), 5);
  EXPECT_FALSE(tested.Constrained.IsFixed(5));
}
