// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/WorstFaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr int Cells = 7;

/// A grid of quads from -Cells/2 to Cells/2, at heights over the plane, whose border is fixed.
struct Grid
{
  template <typename Height>
  Grid(std::vector<ClosestPoints::Corners> triangles, const Height& height)
    : SurfaceContext(triangles)
    , Domain{ this->SurfaceContext, this->NoLines, {}, {} }
  {
    for (int j = 0; j <= Cells; ++j)
    {
      for (int i = 0; i <= Cells; ++i)
      {
        const double x = i - 0.5 * Cells;
        this->Points.emplace_back(x, j - 0.5 * Cells, height(x));
        const bool isFixed = i == 0 || j == 0 || i == Cells || j == Cells;
        this->Domain.Line.push_back(isFixed ? -1 : 0);
        this->Domain.EdgeLength.push_back(1.0);
        if (i < Cells && j < Cells)
        {
          const Index v = j * (Cells + 1) + i;
          this->Cover.Corners.push_back({ v, v + 1, v + Cells + 2, v + Cells + 1 });
          this->Cover.IsRegular.push_back(1);
        }
      }
    }
  }

  double LeastQuality() const
  {
    double least = 1.0;
    for (const Faces::Face& face : this->Cover.Corners)
    {
      least = std::min(least, ScaledJacobian(this->Points, face));
    }
    return least;
  }

  std::vector<ClosestPoints> NoLines;
  ClosestPoints SurfaceContext;
  SmoothingDomain Domain;
  Faces Cover;
  std::vector<Vector3> Points;
};

/// Two rectangles that meet at x = 0, so high.
std::vector<ClosestPoints::Corners> Roof(double slope)
{
  const auto at = [&](double x, double y) { return Vector3(x, y, -slope * std::abs(x)); };
  std::vector<ClosestPoints::Corners> triangles;
  for (const double x : { -4.0, 0.0 })
  {
    triangles.push_back({ at(x, -4.0), at(x + 4.0, -4.0), at(x + 4.0, 4.0) });
    triangles.push_back({ at(x, -4.0), at(x + 4.0, 4.0), at(x, 4.0) });
  }
  return triangles;
}
}

TEST(WorstFaces, DoNotCutOffARidge)
{
  // The quads in the middle lie over the ridge, half an edge on either side.
  constexpr double slope = 2.0;
  Grid grid(Roof(slope), [](double x) { return -slope * std::abs(x); });
  const VertexStars stars(grid.Cover, static_cast<Index>(grid.Points.size()));
  MovableFaces faces(stars, grid.Domain, grid.Points);
  const auto farthest = [&]
  {
    double largest = 0.0;
    // The first row and the last one have corners on the border that stay there.
    for (Index f = Cells; f < faces.GetNumberOfFaces() - Cells; ++f)
    {
      largest = std::max(largest, faces.Distance(f));
    }
    return largest;
  };
  EXPECT_NEAR(farthest(), 0.5 * slope / std::sqrt(1.0 + slope * slope), 1e-12);
  ImproveWorstFaces(faces);
  EXPECT_LT(farthest(), 0.34);
  EXPECT_GT(grid.LeastQuality(), 0.49);
  for (const Vector3& p : grid.Points)
  {
    EXPECT_NEAR(p[2], -slope * std::abs(p[0]), 1e-12);
  }
}

/// On a rough surface the noise decides how far the middles are: the same faces stay as they are.
TEST(WorstFaces, AreNotMovedForTheirDistanceOnARoughSurface)
{
  constexpr double slope = 1.2;
  Grid grid(Roof(slope), [&](double x) { return -slope * std::abs(x); });
  grid.Domain.IsRough = true;
  const VertexStars stars(grid.Cover, static_cast<Index>(grid.Points.size()));
  MovableFaces faces(stars, grid.Domain, grid.Points);
  const std::vector<Vector3> before = grid.Points;
  EXPECT_GT(grid.LeastQuality(), 0.5);
  ImproveWorstFaces(faces);
  EXPECT_EQ(grid.Points, before);
  grid.Domain.IsRough = false;
  ImproveWorstFaces(faces);
  EXPECT_NE(grid.Points, before);
}

TEST(WorstFaces, AreUnfolded)
{
  Grid grid(Roof(0.0), [](double) { return 0.0; });
  const VertexStars stars(grid.Cover, static_cast<Index>(grid.Points.size()));
  MovableFaces faces(stars, grid.Domain, grid.Points);
  // Over the far side of the quads beside it.
  const Index pulled = 3 * (Cells + 1) + 3;
  grid.Points[pulled] += Vector3(1.1, 0.3, 0.0);
  const std::vector<Vector3> before = grid.Points;
  EXPECT_LT(grid.LeastQuality(), 0.0);
  ImproveWorstFaces(faces);
  EXPECT_GT(grid.LeastQuality(), 0.3);
  // Faces that were good, and have no bad one beside them, are left as they were.
  for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
  {
    if ((before[v] - before[pulled]).norm() > 3.5)
    {
      EXPECT_EQ(grid.Points[v], before[v]);
    }
  }
}
