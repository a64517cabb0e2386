// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Mesh/TriangleMesh.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// Two square sheets of cells^2 squares that share their border, bulged apart: a closed surface.
/// Two of the corners are cut off by an edge of both sheets, so that the triangles there have the
/// same corners.
Surface Pillow(int cells)
{
  const Surface square = Square(cells);
  Surface pillow = square;
  std::vector<Index> below(square.Points.size());
  for (std::size_t i = 0; i < square.Points.size(); ++i)
  {
    const Vector3& p = square.Points[i];
    const double height = p.x() * (1.0 - p.x()) * p.y() * (1.0 - p.y());
    below[i] = static_cast<Index>(i);
    if (height > 1e-9)
    {
      below[i] = static_cast<Index>(pillow.Points.size());
      pillow.Points[i].z() = height;
      pillow.Points.emplace_back(p.x(), p.y(), -height);
    }
  }
  for (const Triangle& t : square.Triangles)
  {
    pillow.Triangles.push_back({ below[t[0]], below[t[2]], below[t[1]] });
  }
  return pillow;
}

Triangle Reversed(const Triangle& t)
{
  return { t[0], t[2], t[1] };
}

Surface BackToBack(const Surface& surface)
{
  Surface both = surface;
  for (const Triangle& t : surface.Triangles)
  {
    both.Triangles.push_back(Reversed(t));
  }
  return both;
}

/// The surface with its triangles in another order, their corners turned around.
Surface Reordered(Surface surface, unsigned seed)
{
  std::mt19937 engine(seed);
  for (std::size_t k = surface.Triangles.size(); k > 1; --k)
  {
    std::swap(surface.Triangles[k - 1], surface.Triangles[engine() % k]);
  }
  for (Triangle& t : surface.Triangles)
  {
    std::rotate(t.begin(), t.begin() + engine() % 3, t.end());
  }
  return surface;
}

/// How often each set of three corners is there.
std::map<Triangle, int> CornersOf(const TriangleMesh& mesh)
{
  std::map<Triangle, int> count;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    Triangle corners;
    for (int c = 0; c < 3; ++c)
    {
      corners[c] = mesh.Point(mesh.Tail(3 * t + c));
    }
    std::sort(corners.begin(), corners.end());
    ++count[corners];
  }
  return count;
}

struct Expected
{
  Index Duplicates = 0;
  Index NonManifoldEdges = 0;
  std::size_t Components = 1;
  bool Closed = true;
  int Characteristic = 2;
};

/// The same is found in whatever order the triangles come.
void ExpectInAnyOrder(const Surface& surface, const Expected& expected)
{
  const auto kept = CornersOf(TriangleMesh(surface));
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const TriangleMesh mesh(seed == 0 ? surface : Reordered(surface, seed));
    EXPECT_EQ(mesh.GetRepairs().DuplicateTriangles, expected.Duplicates);
    EXPECT_EQ(mesh.GetRepairs().NonManifoldEdges, expected.NonManifoldEdges);
    ASSERT_EQ(mesh.GetComponents().size(), expected.Components);
    for (const TriangleMesh::Component& component : mesh.GetComponents())
    {
      EXPECT_EQ(component.Closed, expected.Closed);
      EXPECT_EQ(
        component.Vertices() - component.Edges() + component.Triangles(), expected.Characteristic);
    }
    EXPECT_EQ(CornersOf(mesh), kept);
  }
}
}

TEST(DuplicateTriangles, SameWindingIsADuplicate)
{
  Surface surface = Icosphere(1);
  const std::vector<Triangle> triangles = surface.Triangles;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    surface.Triangles.push_back({ triangles[t][1], triangles[t][2], triangles[t][0] });
    surface.Triangles.push_back(triangles[t]);
  }
  ExpectInAnyOrder(surface, { 54, 0, 1, true, 2 });
}

TEST(DuplicateTriangles, BackToBackIsOneSheet)
{
  ExpectInAnyOrder(BackToBack(Disk(1)), { 6, 0, 1, false, 1 });
  // Closed, too: no other sheet goes on from it.
  ExpectInAnyOrder(BackToBack(Tetrahedron()), { 4, 0, 1, true, 2 });
  // A triangle of a closed surface that is there once more, the other way round, adds nothing.
  // Which of the two stays is up to the order, and is turned if need be.
  Surface once = Icosahedron();
  once.Triangles.push_back(Reversed(once.Triangles[7]));
  const TriangleMesh mesh(once);
  EXPECT_EQ(mesh.GetRepairs().DuplicateTriangles, 1);
  EXPECT_TRUE(mesh.GetComponents().front().Closed);
}

TEST(DuplicateTriangles, PillowsStayClosed)
{
  for (const int cells : { 2, 3, 6 })
  {
    const Surface pillow = Pillow(cells);
    ExpectInAnyOrder(pillow, {});
    for (unsigned seed = 0; seed < 3; ++seed)
    {
      Options options;
      options.ConstrainSharpEdges = seed == 1;
      options.IntrinsicDelaunay = seed == 2;
      const Result result = DirectionField(Reordered(pillow, seed)).Compute(options);
      ASSERT_EQ(result.Components.size(), 1u);
      EXPECT_EQ(result.Components[0].IndexSum, 8);
      EXPECT_EQ(result.Components[0].EulerCharacteristic, 2);
      EXPECT_TRUE(result.Components[0].Converged);
    }
    // The pillow that is there twice is still one.
    Surface twice = pillow;
    twice.Triangles.insert(twice.Triangles.end(), pillow.Triangles.begin(), pillow.Triangles.end());
    ExpectInAnyOrder(twice, { static_cast<Index>(pillow.Triangles.size()), 0, 1, true, 2 });
  }
}

TEST(DuplicateTriangles, WallsBetweenClosedCellsBelongToBoth)
{
  // A tetrahedron, and another one on its face 0 2 1.
  Surface cells = Tetrahedron();
  const Triangle wall = Reversed(cells.Triangles[0]);
  const Vector3 outside = cells.Points[wall[0]] + cells.Points[wall[1]] + cells.Points[wall[2]];
  cells.Points.push_back(outside);
  const auto tip = static_cast<Index>(cells.Points.size() - 1);
  cells.Triangles.push_back(wall);
  for (int c = 0; c < 3; ++c)
  {
    cells.Triangles.push_back({ wall[(c + 1) % 3], wall[c], tip });
  }
  ExpectInAnyOrder(cells, { 0, 0, 2, true, 2 });
}
