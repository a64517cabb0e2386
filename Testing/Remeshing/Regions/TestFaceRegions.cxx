// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Regions/FaceRegions.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

using namespace DirectionFields;

namespace
{
constexpr int Cells = 10;

/// A square of faces, with a line of the number given halfway.
FaceMesh Halves(Index line)
{
  FaceMesh mesh;
  const auto point = [](int i, int j) { return static_cast<Index>((Cells + 1) * j + i); };
  for (int j = 0; j <= Cells; ++j)
  {
    for (int i = 0; i <= Cells; ++i)
    {
      mesh.Points.emplace_back(i, j, 0.0);
    }
  }
  for (int j = 0; j < Cells; ++j)
  {
    for (int i = 0; i < Cells; ++i)
    {
      mesh.Cells.Corners.push_back(
        { point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) });
    }
    mesh.LineEdges.push_back({ { point(Cells / 2, j), point(Cells / 2, j + 1) }, line });
  }
  mesh.Cells.IsRegular.assign(mesh.Cells.Corners.size(), 1);
  return mesh;
}

/// 0 for the left half, and 1 for the right one.
std::vector<Index> Sides()
{
  std::vector<Index> sides;
  for (int f = 0; f < Cells * Cells; ++f)
  {
    sides.push_back(f % Cells < Cells / 2 ? 0 : 1);
  }
  return sides;
}
}

TEST(FaceRegions, MostOfTheAreaThatBordersEncloseDecides)
{
  // The triangles are the faces' own, but for one face that is closest to the other side.
  std::vector<Index> closest(Cells * Cells);
  for (std::size_t f = 0; f < closest.size(); ++f)
  {
    closest[f] = static_cast<Index>(f);
  }
  closest[4] = 5;
  const std::vector<Index> found = RegionsOfFaces(Halves(1), Sides(), closest, { 0, 1 });
  EXPECT_EQ(found, Sides());

  // Where the line is no border neither side decides for the other, nor for the face.
  const std::vector<Index> open = RegionsOfFaces(Halves(1), Sides(), closest, { 0, 0 });
  std::vector<Index> asClose = Sides();
  asClose[4] = 1;
  EXPECT_EQ(open, asClose);
}

TEST(FaceRegions, SourcesAreTheClosestTrianglesOfTheFacesRegion)
{
  const Surface square = Meshes::Square(Cells, Cells);
  const PreparedSurface prepared(square, 4, FeatureSettings{ true, 40.0, 0.5, 0.0 });
  std::vector<Index> regions;
  for (const Triangle& t : square.Triangles)
  {
    const double x = square.Points[t[0]].x() + square.Points[t[1]].x() + square.Points[t[2]].x();
    regions.push_back(x < 1.5 * Cells ? 0 : 1);
  }
  const FaceMesh mesh = Halves(1);
  // All faces begin with a triangle in a corner of the left half.
  std::vector<Index> closest(mesh.Cells.Corners.size(), 0);
  FindInRegions(prepared, mesh, regions, Sides(), closest);
  for (std::size_t f = 0; f < closest.size(); ++f)
  {
    EXPECT_EQ(regions[closest[f]], Sides()[f]);
    if (Sides()[f] == 1)
    {
      const Triangle& t = square.Triangles[closest[f]];
      const Vector3 middle =
        (square.Points[t[0]] + square.Points[t[1]] + square.Points[t[2]]) / 3.0;
      EXPECT_LT((middle - MiddleOf(mesh.Points, mesh.Cells.Corners[f])).norm(), 0.5) << f;
    }
    else
    {
      EXPECT_EQ(closest[f], 0);
    }
  }
}
