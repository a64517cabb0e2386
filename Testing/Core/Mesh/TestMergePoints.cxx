// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Mesh/MergePoints.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options Merging(bool merge = true)
{
  Options options;
  options.MergePoints = merge;
  return options;
}

/// The soup's result at each corner is the connected surface's.
void ExpectSameAtCorners(const Surface& surface, const Result& connected, const Result& soup)
{
  ASSERT_EQ(soup.Components.size(), connected.Components.size());
  EXPECT_EQ(soup.SingularityIndex, connected.SingularityIndex);
  EXPECT_EQ(soup.Component, connected.Component);
  for (std::size_t c = 0; c < soup.Components.size(); ++c)
  {
    EXPECT_EQ(soup.Components[c].Eigenvalue, connected.Components[c].Eigenvalue);
    EXPECT_EQ(soup.Components[c].Vertices, connected.Components[c].Vertices);
  }
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners =
      connected.SplitTriangles.empty() ? surface.Triangles[t] : connected.SplitTriangles[t];
    for (int c = 0; c < 3; ++c)
    {
      const auto own = static_cast<Index>(3 * t + c);
      EXPECT_EQ(soup.Representation[own], connected.Representation[corners[c]]);
      EXPECT_EQ(soup.Normal[own], connected.Normal[corners[c]]);
      EXPECT_EQ(soup.Direction(own, 1), connected.Direction(corners[c], 1));
    }
  }
}
}

TEST(MergePoints, FindsTheFirstPointAtEachPlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  // Point 0 is used by no triangle, points 4 and 5 differ in the last bit.
  const Surface surface{ { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 2, 0 },
                           { std::nextafter(0.3, 1.0), 2, 0 }, { -0.0, 0.0, -0.0 }, { 1, 0, 0 },
                           { nan, 0, 0 }, { nan, 0, 0 }, { 0, 1, 0 } },
    { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } } };
  EXPECT_EQ(FirstAtSamePlace(surface), (std::vector<Index>{ 0, 1, 2, 3, 4, 5, 1, 2, 8, 9, 10 }));
  EXPECT_EQ(Merged(surface, FirstAtSamePlace(surface)).Triangles,
    (std::vector<Triangle>{ { 1, 2, 3 }, { 4, 5, 1 }, { 2, 8, 9 } }));
}

TEST(MergePoints, SoupHasTheFieldOfTheConnectedSurface)
{
  // The fin splits the square along an edge.
  Surface fin = Square(4);
  fin.Points.emplace_back(0.5, 0.3, 1.0);
  fin.Triangles.push_back({ 7, 12, 25 });
  for (const Surface& surface : { Potato(2), Torus(12, 8), Joined(Cube(), Disk(4)), fin })
  {
    const Result connected = DirectionField(surface).Compute(Merging(false));
    EXPECT_TRUE(connected.Notes.empty());
    const Surface soup = Soup(surface);
    const Result merged = DirectionField(soup).Compute(Merging());
    EXPECT_TRUE(merged.Notes.empty());
    // Each corner has a point that can carry its own sheet's directions.
    EXPECT_EQ(merged.OriginalPoint.size(), soup.Points.size());
    EXPECT_TRUE(merged.SplitTriangles.empty());
    ExpectSameAtCorners(surface, connected, merged);
  }
}

TEST(MergePoints, SplitsPointsThatBelongToSeveralFans)
{
  // A bow-tie of two squares: one joined by its points, one by places only.
  Surface squares =
    Joined(Square(2), Transformed(Square(2), Eigen::Matrix3d::Identity(), { 1, 1, 0 }));
  Surface glued = squares;
  for (Triangle& t : glued.Triangles)
  {
    std::replace(t.begin(), t.end(), Index(9), Index(8));
  }
  const Result result = DirectionField(squares).Compute(Merging());
  EXPECT_EQ(result.Repaired.NonManifoldPoints, 1);
  EXPECT_EQ(result.Components.size(), 2u);
  // Points 8 and 9 are there for the two fans.
  EXPECT_EQ(result.OriginalPoint.size(), 18u);
  const Result shared = DirectionField(glued).Compute(Merging());
  EXPECT_EQ(shared.Repaired.NonManifoldPoints, 1);
  ASSERT_EQ(shared.OriginalPoint.size(), 19u);
  EXPECT_EQ(shared.OriginalPoint[18], 8);
  EXPECT_TRUE(result.SplitTriangles.empty());
  EXPECT_FALSE(shared.SplitTriangles.empty());
}

TEST(MergePoints, TrianglesThatShrinkToAnEdgeAreIgnored)
{
  Surface surface = Potato(1);
  const Index copy = static_cast<Index>(surface.Points.size());
  surface.Points.push_back(surface.Points[0]);
  surface.Triangles.push_back({ 0, 1, copy });
  const Result result = DirectionField(surface).Compute(Merging());
  EXPECT_EQ(result.Repaired.CollapsedTriangles, 1);
  EXPECT_EQ(result.Component.back(), None);
  ASSERT_EQ(result.Components.size(), 1u);
  EXPECT_EQ(result.Components[0].IndexSum, 8);
  EXPECT_EQ(result.OriginalPoint.size(), surface.Points.size());
  // Only the ignored triangle uses the copy, or the point that stands for it.
  EXPECT_NE(result.Representation[0], 0.0);
  EXPECT_EQ(result.Representation[copy], result.Representation[0]);
  for (Triangle& t : surface.Triangles)
  {
    std::replace(t.begin(), t.end(), Index(0), copy);
  }
  surface.Triangles.back() = { 0, 1, copy };
  const Result other = DirectionField(surface).Compute(Merging());
  EXPECT_EQ(other.Representation, result.Representation);
}

TEST(MergePoints, TheSwitchTakesEffectOnTheNextCall)
{
  const Surface soup = Soup(Potato(1));
  DirectionField field(soup);
  for (const bool merge : { false, true, true, false })
  {
    const Result result = field.Compute(Merging(merge));
    const Result fresh = DirectionField(soup).Compute(Merging(merge));
    EXPECT_EQ(result.Representation, fresh.Representation);
    EXPECT_EQ(result.Components.size(), merge ? 1u : 80u);
  }
}

TEST(MergePoints, GuidanceIsThatOfTheFirstPointThatHasAny)
{
  const Surface surface = Disk(4);
  const Surface soup = Soup(surface);
  Options options = Merging();
  options.ConstrainGuidance = true;
  const Vector3 vector(1.0, 0.4, 0.0);
  const std::vector<Index> first = FirstAtSamePlace(soup);
  // A corner that is not the first at its place.
  Index later = 0;
  while (first[later] == later)
  {
    ++later;
  }
  const Result result =
    DirectionField(soup).Compute(options, GuidanceAt(soup, { { later, vector } }));
  EXPECT_NEAR(Deviation(result, later, vector), 0.0, 1e-9);
  EXPECT_NEAR(Deviation(result, first[later], vector), 0.0, 1e-9);
  // The first comes first.
  const Result both = DirectionField(soup).Compute(
    options, GuidanceAt(soup, { { later, Vector3(0.3, 1.0, 0.0) }, { first[later], vector } }));
  EXPECT_NEAR(Deviation(both, later, vector), 0.0, 1e-9);
}

TEST(MergePoints, ANoteTellsSoupFromSurfacesWithABoundary)
{
  const auto notes = [](const Surface& surface)
  { return DirectionField(surface).Compute(Merging(false)).Notes; };
  const Surface triangle{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  for (const Surface& surface : { triangle, Square(5), Potato(1), Cylinder(8, 3, 1.0) })
  {
    EXPECT_TRUE(notes(surface).empty());
  }
  ASSERT_EQ(notes(Soup(Tetrahedron())).size(), 1u);
  EXPECT_EQ(notes(Soup(Tetrahedron()))[0].rfind("12 of the 12 points", 0), 0u);
  EXPECT_NE(notes(Soup(Tetrahedron()))[0].find("MergePoints"), std::string::npos);
  // Two squares of 16 boundary points each that touch along a side of 5 points, 10 of 32: a seam.
  EXPECT_TRUE(
    notes(Joined(Square(4), Transformed(Square(4), Eigen::Matrix3d::Identity(), { 1, 0, 0 })))
      .empty());
  // Of 2 triangles: 4 of 6.
  EXPECT_EQ(notes(Soup(Square(1))).size(), 1u);
}
