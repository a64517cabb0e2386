// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/GridPoints.h"

#include "Extraction/DelaunayFlips.h"
#include "Extraction/Pairing.h"
#include "Extraction/VertexRemoval.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

#include <memory>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
/// The mesh of a map without cones of a torus: it covers the plane modulo the grid.
ExtractionMesh CoveringTorus(int degree)
{
  const CutExample example = CutExample::AlongParallels(Meshes::Torus(24, 16), degree);
  const IntegerGridMap map(example.Mesh, example.Settings(3.0));
  EXPECT_FALSE(map.GetFailure());
  return { example.Mesh, map };
}

constexpr int Side = 5;
ExtractionMesh MappedSquare()
{
  const CutExample example = CutExample::AlongX(Meshes::Square(7), 4);
  return { example.Mesh, IntegerGridMap(example.Mesh, example.Settings(Side)) };
}

/// The area in parallelograms of the grid, which is a whole number for these.
Index CellsOf(const ExtractionMesh& mesh)
{
  return static_cast<Index>(Meshes::TwiceAreaOf(mesh) / (2 * Meshes::SquaredUnit));
}

Index CountKept(const ExtractionMesh& mesh, bool onBoundary)
{
  Index kept = 0;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    kept += mesh.IsVertex(v) && mesh.GetRole(v).IsKept && mesh.IsBoundary(v) == onBoundary ? 1 : 0;
  }
  return kept;
}

Index CountTriangles(const ExtractionMesh& mesh)
{
  Index count = 0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    count += mesh.IsTriangle(t) ? 1 : 0;
  }
  return count;
}

/// Edges beyond which a vertex lies inside of the circle around a triangle: the sum of the angles
/// opposite of them is more than pi.
Index CountNotDelaunay(const ExtractionMesh& mesh)
{
  const IntegerGrid& plane = mesh.GetPlane();
  const auto angleAt = [&](Index h)
  {
    const Complex tip = plane.Place(mesh.Place(h));
    const Complex u = plane.Place(mesh.Place(ExtractionMesh::Next(h))) - tip;
    const Complex v = plane.Place(mesh.Place(ExtractionMesh::Previous(h))) - tip;
    return std::arg(v / u);
  };
  Index count = 0;
  for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
  {
    const Index g = mesh.IsTriangle(h / 3) ? mesh.Twin(h) : None;
    if (g > h && mesh.IsPositive(h / 3) && mesh.IsPositive(g / 3))
    {
      const double sum =
        angleAt(ExtractionMesh::Previous(h)) + angleAt(ExtractionMesh::Previous(g));
      count += sum > Pi + 1e-6 ? 1 : 0;
    }
  }
  return count;
}
}

TEST(GridPoints, AreAsManyAsTheTorusHasCells)
{
  // Every class of points of the plane modulo the grid is covered as often as the area says.
  for (const int degree : { 4, 6 })
  {
    ExtractionMesh mesh = CoveringTorus(degree);
    const Index cells = CellsOf(mesh);
    ASSERT_GT(cells, 50);
    InsertGridPoints(mesh);
    EXPECT_EQ(CountKept(mesh, false), cells);
    EXPECT_EQ(CellsOf(mesh), cells);
    EXPECT_EQ(mesh.EulerCharacteristic(), 0);
  }
}

TEST(GridPoints, SatisfyTheTheoremOfPick)
{
  ExtractionMesh mesh = MappedSquare();
  InsertGridPoints(mesh);
  const Index inside = CountKept(mesh, false);
  const Index onBoundary = CountKept(mesh, true);
  EXPECT_EQ(onBoundary, 4 * Side);
  // A = I + B / 2 - 1
  EXPECT_EQ(2 * CellsOf(mesh), 2 * inside + onBoundary - 2);
}

TEST(GridPoints, LieWhereTheMapHasThemInSpace)
{
  ExtractionMesh mesh = MappedSquare();
  InsertGridPoints(mesh);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsVertex(v) && mesh.GetRole(v).IsKept)
    {
      const Vector3 scaled = Side * mesh.Position(v);
      EXPECT_NEAR((scaled - scaled.array().round().matrix()).norm(), 0.0, 1e-4);
    }
  }
}

TEST(DelaunayFlips, LeaveNoVertexInTheCircleAroundATriangle)
{
  for (const int degree : { 4, 6 })
  {
    const CutExample example =
      CutExample::AlongParallels(Meshes::Jittered(Meshes::Torus(24, 16), 0.03, 3), degree);
    const IntegerGridMap map(example.Mesh, example.Settings(5.0));
    ExtractionMesh mesh(example.Mesh, map);
    EXPECT_GT(CountNotDelaunay(mesh), 10);
    const auto area = Meshes::TwiceAreaOf(mesh);
    std::vector<Index> edges(3 * mesh.GetNumberOfTriangles());
    for (std::size_t h = 0; h < edges.size(); ++h)
    {
      edges[h] = static_cast<Index>(h);
    }
    MakeDelaunay(mesh, edges);
    EXPECT_TRUE(edges.empty());
    EXPECT_EQ(CountNotDelaunay(mesh), 0);
    EXPECT_TRUE(Meshes::TwiceAreaOf(mesh) == area);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
  }
}

TEST(VertexRemoval, LeavesTheHalfCellsOfTheGrid)
{
  for (const int degree : { 4, 6 })
  {
    ExtractionMesh mesh = CoveringTorus(degree);
    const Index cells = CellsOf(mesh);
    InsertGridPoints(mesh);
    EXPECT_EQ(VertexRemoval(mesh).RemoveAll(VertexRemoval::Mode::Strict), 0);
    EXPECT_EQ(CountTriangles(mesh), 2 * cells);
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      if (mesh.IsTriangle(t))
      {
        EXPECT_TRUE(Meshes::TwiceAreaOfTriangle(mesh.Place(3 * t), mesh.Place(3 * t + 1),
                      mesh.Place(3 * t + 2)) == Meshes::SquaredUnit);
      }
    }
    EXPECT_EQ(mesh.EulerCharacteristic(), 0);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
  }
}

TEST(Pairing, MakesEveryCellOfTheGridAFace)
{
  for (const int degree : { 4, 6 })
  {
    ExtractionMesh mesh = CoveringTorus(degree);
    const Index cells = CellsOf(mesh);
    InsertGridPoints(mesh);
    VertexRemoval(mesh).RemoveAll(VertexRemoval::Mode::Strict);
    const Faces faces = PairTriangles(mesh);
    ASSERT_EQ(faces.Corners.size(), static_cast<std::size_t>(degree == 4 ? cells : 2 * cells));
    for (std::size_t f = 0; f < faces.Corners.size(); ++f)
    {
      EXPECT_EQ(Faces::Size(faces.Corners[f]), degree == 4 ? 4 : 3);
      EXPECT_EQ(faces.IsRegular[f], 1);
    }
    EXPECT_EQ(EulerCharacteristic(cells, faces), 0);
  }
}
