// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/IntegerGridMap.h"

#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
std::vector<Surface> Examples()
{
  return { Meshes::Icosphere(2), Meshes::Torus(12, 9), Meshes::DoubleTorus(), Meshes::Disk(4),
    Meshes::Cylinder(9, 4, 1.0), Meshes::PlateWithHole(12, 4, 0.4, true), Meshes::Potato(2) };
}

/// The transition once around a vertex, back to the chart of the first triangle; the identity on the
/// boundary.
Transition Around(const ExtractionMesh& mesh, Index v)
{
  const IntegerGrid& plane = mesh.GetPlane();
  std::vector<Index> star;
  Transition around;
  if (!mesh.GetStar(v, star))
  {
    for (const Index h : star)
    {
      around = plane.Composed(around, mesh.Across(ExtractionMesh::Previous(h)));
    }
  }
  return around;
}
}

TEST(IntegerGridMap, AgreesAcrossEveryEdgeExactly)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 10);
      const CutMesh& mesh = example.Mesh;
      const IntegerGridMap map(mesh, example.Settings(10.0));
      ASSERT_FALSE(map.GetFailure());
      const IntegerGrid plane(degree);
      const auto next = [](std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
      for (std::size_t h = 0; h < map.GetCorners().size(); ++h)
      {
        const Index twin = mesh.Triangles[h / 3].Twin[h % 3];
        if (twin == None)
        {
          continue;
        }
        const auto g = static_cast<std::size_t>(twin);
        EXPECT_EQ(plane.Apply(map.GetAcross()[h], map.GetCorners()[g]), map.GetCorners()[next(h)]);
        EXPECT_EQ(plane.Apply(map.GetAcross()[h], map.GetCorners()[next(g)]), map.GetCorners()[h]);
        EXPECT_TRUE(IntegerGrid::IsGridPoint(map.GetAcross()[h].Shift));
      }
    }
  }
}

TEST(IntegerGridMap, ConesAreGridPointsAndFeaturesAreLinesOfTheGrid)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 11);
      const CutMesh& mesh = example.Mesh;
      const IntegerGridMap map(mesh, example.Settings(10.0));
      std::vector<char> isCone(mesh.Positions.size(), 0);
      for (const CutMesh::Cone& cone : mesh.Cones)
      {
        isCone[cone.Vertex] = 1;
      }
      for (std::size_t h = 0; h < map.GetCorners().size(); ++h)
      {
        if (isCone[mesh.Triangles[h / 3].Vertex[h % 3]] != 0)
        {
          EXPECT_TRUE(IntegerGrid::IsGridPoint(map.GetCorners()[h]));
        }
      }
      const IntegerGrid plane(degree);
      for (const CutMesh::IsolineEdge& edge : mesh.Isolines)
      {
        const std::size_t h = 3 * edge.Triangle;
        const GridPoint p = plane.Turned(map.GetCorners()[h + edge.Corner], -edge.Axis);
        const GridPoint q = plane.Turned(map.GetCorners()[h + (edge.Corner + 1) % 3], -edge.Axis);
        EXPECT_EQ(p.B, q.B);
        EXPECT_EQ(p.B % IntegerGrid::Unit, 0);
      }
    }
  }
}

TEST(IntegerGridMap, TransitionsAroundRegularVerticesComposeToTheIdentity)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 12);
      const IntegerGridMap map(example.Mesh, example.Settings(10.0));
      const ExtractionMesh mesh(example.Mesh, map);
      std::vector<int> turn(mesh.GetNumberOfVertices(), 0);
      for (const CutMesh::Cone& cone : example.Mesh.Cones)
      {
        turn[cone.Vertex] = cone.Holonomy.Turn;
      }
      Index regular = 0;
      for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const Transition around = Around(mesh, v);
        EXPECT_EQ(around.Turn != 0, turn[v] != 0);
        if (turn[v] == 0)
        {
          EXPECT_EQ(around, Transition());
          ++regular;
        }
      }
      EXPECT_GT(regular, 0);
    }
  }
}

TEST(IntegerGridMap, TorusCoversTheQuotientOfThePlaneAWholeNumberOfTimes)
{
  // Along its parallels a torus has no cones: the map is a covering of the plane modulo the grid.
  for (const int degree : { 4, 6 })
  {
    const CutExample example = CutExample::AlongParallels(Meshes::Torus(24, 16), degree);
    for (const CutMesh::Cone& cone : example.Mesh.Cones)
    {
      ASSERT_EQ(cone.Holonomy.Turn, 0);
    }
    const double perLength = 7.0;
    const IntegerGridMap map(example.Mesh, example.Settings(perLength));
    ASSERT_FALSE(map.GetFailure());
    EXPECT_EQ(map.CountFlipped(), 0);
    const auto area = Meshes::TwiceAreaOf(map.GetCorners());
    EXPECT_TRUE(area % (2 * Meshes::SquaredUnit) == 0);
    // 4 pi^2 R r, up to the rounding of the two loops.
    const double wanted = 4.0 * Pi * Pi * 1.0 * 0.4 * perLength * perLength *
      (degree == 4 ? 1.0 : 2.0 / std::sqrt(3.0));
    EXPECT_NEAR(static_cast<double>(area) / (2.0 * static_cast<double>(Meshes::SquaredUnit)),
      wanted, 0.1 * wanted);
  }
}

TEST(IntegerGridMap, SquareIsMappedByASimilarity)
{
  constexpr int side = 5;
  const CutExample example = CutExample::AlongX(Meshes::Square(7), 4);
  const IntegerGridMap map(example.Mesh, example.Settings(side));
  ASSERT_FALSE(map.GetFailure());
  EXPECT_TRUE(Meshes::TwiceAreaOf(map.GetCorners()) == 2 * side * side * Meshes::SquaredUnit);
  const IntegerGrid plane(4);
  for (std::size_t h = 0; h < map.GetCorners().size(); ++h)
  {
    const CutMesh::MapTriangle& t = example.Mesh.Triangles[h / 3];
    const std::size_t next = h % 3 == 2 ? h - 2 : h + 1;
    const double inSpace =
      (example.Mesh.Positions[t.Vertex[(h + 1) % 3]] - example.Mesh.Positions[t.Vertex[h % 3]])
        .norm();
    EXPECT_NEAR(std::abs(plane.Place(map.GetCorners()[next] - map.GetCorners()[h])), side * inSpace,
      4.0 / IntegerGrid::Unit);
  }
}

TEST(IntegerGridMap, SaysWhyThereIsNone)
{
  const CutExample example = CutExample::AlongX(Meshes::Square(3), 4);
  const IntegerGridMap map(example.Mesh, example.Settings(1e6));
  EXPECT_EQ(map.GetFailure(), MapFailure::TooManyCells);
  std::set<std::string> sentences;
  for (const MapFailure failure : { MapFailure::TooManyCells, MapFailure::NoSolution,
         MapFailure::OutOfRange, MapFailure::ExcessiveArea })
  {
    sentences.insert(Sentence(failure));
  }
  EXPECT_EQ(sentences.size(), 4U);
}
