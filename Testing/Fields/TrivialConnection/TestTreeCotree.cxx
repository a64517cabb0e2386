// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/TreeCotree.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Components::Tested;

namespace
{
struct Shape
{
  Surface Mesh;
  int Genus;
  int Boundaries;
};

std::vector<Shape> Shapes()
{
  return { { Meshes::Icosphere(2), 0, 0 }, { Meshes::Torus(16, 9), 1, 0 },
    { Meshes::FlatlySubdivided(Meshes::DoubleTorus(), 1), 2, 0 }, { Meshes::Disk(5), 0, 1 },
    { Meshes::Cylinder(12, 5, 2.0), 0, 2 }, { Meshes::PlateWithHole(16, 4, 0.5, false), 0, 2 } };
}

/// The integral of a form along a loop that begins at the tail of its first edge.
double Along(const Tested& tested, const EdgeForm& form, const std::vector<Index>& loop)
{
  Index at = tested.Mesh.Tail(tested.Mesh.HalfEdge(tested.Component.FirstEdge + loop.front()));
  const Index start = at;
  double sum = 0.0;
  for (const Index e : loop)
  {
    const Index h = tested.Mesh.HalfEdge(tested.Component.FirstEdge + e);
    const bool isForward = tested.Mesh.Tail(h) == at;
    EXPECT_TRUE(isForward || tested.Mesh.Head(h) == at);
    sum += isForward ? form[e] : -form[e];
    at = isForward ? tested.Mesh.Head(h) : tested.Mesh.Tail(h);
  }
  EXPECT_EQ(at, start);
  return sum;
}
}

TEST(TreeCotree, HasAGeneratorForEachHandleAndBoundary)
{
  for (const Shape& shape : Shapes())
  {
    const Tested tested(shape.Mesh);
    EXPECT_EQ(static_cast<int>(tested.Trees.GetGenerators().size()),
      2 * shape.Genus + std::max(0, shape.Boundaries - 1));
    EXPECT_EQ(tested.Trees.GetNumberOfRegions(), 1);
    EXPECT_EQ(tested.Trees.IsOpen(0), shape.Boundaries > 0);
  }
}

/// Forms cross edges of the tree of triangles and loops run along edges of the tree of vertices: these are disjoint, so
/// that each loop meets its own generator only.
TEST(TreeCotree, FormsAndLoopsAreDualBases)
{
  for (const Shape& shape : Shapes())
  {
    const Tested tested(shape.Mesh);
    const std::size_t count = tested.Trees.GetGenerators().size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const EdgeForm form = tested.Dense(tested.Trees.FormOf(i));
      EXPECT_EQ(tested.LargestCurl(form), 0.0);
      for (std::size_t j = 0; j < count; ++j)
      {
        EXPECT_EQ(Along(tested, form, tested.Trees.LoopOf(j)), i == j ? 1.0 : 0.0);
      }
    }
  }
}

TEST(TreeCotree, RoutesAnyNumbersThatAddUpToZero)
{
  for (const Shape& shape : Shapes())
  {
    const Tested tested(shape.Mesh);
    std::mt19937 random(6);
    std::vector<int> around(tested.Component.Triangles());
    int sum = 0;
    for (int& number : around)
    {
      number = static_cast<int>(random() % 5) - 2;
      sum += number;
    }
    // Through a boundary the rest goes out.
    around.front() -= shape.Boundaries > 0 ? 0 : sum;
    const IntegerForm routed = tested.Trees.Route(around);
    const EdgeForm form(routed.begin(), routed.end());
    for (Index t = 0; t < tested.Component.Triangles(); ++t)
    {
      EXPECT_EQ(tested.Forms.Around(form, t), around[t]);
    }
  }
}

TEST(TreeCotree, GivenDirectionsPartRegions)
{
  // The middle ring of a torus cannot part it, the rings at both of its ends can.
  constexpr int around = 16;
  constexpr int across = 8;
  const Surface torus = Meshes::Torus(around, across);
  std::vector<Index> ring;
  std::vector<Index> rings;
  for (Index i = 0; i < static_cast<Index>(torus.Points.size()); ++i)
  {
    const double angle = std::atan2(torus.Points[i].y(), torus.Points[i].x());
    if (std::abs(angle) < 1e-9)
    {
      ring.push_back(i);
    }
    if (std::abs(std::sin(angle)) < 1e-9)
    {
      rings.push_back(i);
    }
  }
  ASSERT_EQ(ring.size(), static_cast<std::size_t>(across));
  ASSERT_EQ(rings.size(), static_cast<std::size_t>(2 * across));
  const Tested one(torus, ring);
  EXPECT_EQ(one.Trees.GetNumberOfRegions(), 1);
  const Tested two(torus, rings);
  ASSERT_EQ(two.Trees.GetNumberOfRegions(), 2);
  EXPECT_FALSE(two.Trees.IsOpen(0) || two.Trees.IsOpen(1));
  // No path crosses a given edge.
  for (std::size_t k = 0; k < two.Trees.GetGenerators().size(); ++k)
  {
    for (const TreeCotree::Term& term : two.Trees.FormOf(k))
    {
      EXPECT_FALSE(two.Constrained.IsFixed(term.Edge));
    }
  }
}
