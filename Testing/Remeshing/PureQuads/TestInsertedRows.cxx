// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/InsertedRows.h"

#include "Meshes/FacesAtEdges.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// A square of unit quads, of which some are cut into two triangles from their first corner on.
FaceMesh Grid(Index cells, const std::set<Index>& cut)
{
  FaceMesh mesh;
  const auto at = [&](Index i, Index j) { return j * (cells + 1) + i; };
  for (Index j = 0; j <= cells; ++j)
  {
    for (Index i = 0; i <= cells; ++i)
    {
      mesh.Points.emplace_back(i, j, 0.0);
      mesh.Vertices.emplace_back();
      if (i == cells || j == cells)
      {
        continue;
      }
      const Faces::Face quad = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      if (cut.count(j * cells + i) > 0)
      {
        mesh.Cells.Corners.push_back({ quad[0], quad[1], quad[2], None });
        mesh.Cells.Corners.push_back({ quad[0], quad[2], quad[3], None });
        mesh.Cells.IsRegular.resize(mesh.Cells.Corners.size(), 0);
      }
      else
      {
        mesh.Cells.Corners.push_back(quad);
        mesh.Cells.IsRegular.push_back(1);
      }
    }
  }
  return mesh;
}

double Area(const FaceMesh& mesh)
{
  double sum = 0.0;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    sum += AreaVector(mesh.Points, face)[2];
  }
  return sum;
}
}

TEST(InsertedRows, MakeQuadsOfAllTrianglesAndChangeNoRim)
{
  for (const std::set<Index>& cut :
    { std::set<Index>{ 0 }, { 9, 14 }, { 0, 63 }, { 9, 54 }, { 1, 7, 20, 33, 46, 62 } })
  {
    FaceMesh mesh = Grid(8, cut);
    const auto before = Meshes::FacesAtEdges(mesh.Cells.Corners);
    EXPECT_EQ(InsertRows(mesh), 0);
    const auto after = Meshes::FacesAtEdges(mesh.Cells.Corners);
    for (const auto& [ends, faces] : before)
    {
      const auto found = after.find(ends);
      EXPECT_TRUE(faces == 2 || (found != after.end() && found->second == 1));
    }
    for (const auto& [ends, faces] : after)
    {
      EXPECT_TRUE(faces == 2 || before.at(ends) == 1);
    }
    for (const Faces::Face& face : mesh.Cells.Corners)
    {
      EXPECT_EQ(Faces::Size(face), 4);
      // Middles of edges are on these, so that ends of rows are flat corners until vertices move.
      EXPECT_GE(ScaledJacobian(mesh.Points, face), -1e-12);
    }
    EXPECT_EQ(EulerCharacteristic(static_cast<Index>(mesh.Points.size()), mesh.Cells), 1);
    EXPECT_NEAR(Area(mesh), 64.0, 1e-12);
    EXPECT_EQ(mesh.Cells.IsRegular.size(), mesh.Cells.Corners.size());
    EXPECT_EQ(mesh.Vertices.size(), mesh.Points.size());
  }
}

TEST(InsertedRows, DoNotCrossLines)
{
  // A line in the middle, with one cut quad on each side: two triangles a side.
  FaceMesh mesh = Grid(8, { 18, 22 });
  std::set<std::array<Index, 2>> line;
  for (Index j = 0; j < 8; ++j)
  {
    line.insert({ 9 * j + 4, 9 * (j + 1) + 4 });
    mesh.LineEdges.push_back({ { 9 * j + 4, 9 * (j + 1) + 4 }, 1 });
  }
  EXPECT_EQ(InsertRows(mesh), 0);
  const auto edges = Meshes::FacesAtEdges(mesh.Cells.Corners);
  for (const std::array<Index, 2>& ends : line)
  {
    EXPECT_EQ(edges.count(ends), 1U);
  }
  // A single triangle on one side finds no other one.
  FaceMesh alone = Grid(2, {});
  alone.Cells.Corners[0] = { 0, 1, 4, None };
  EXPECT_EQ(InsertRows(alone), 1);
  EXPECT_EQ(alone.Cells.Corners.size(), 4U);
}
