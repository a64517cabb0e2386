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
Options Merging(MergePoints which)
{
  Options options;
  options.MergePoints = which;
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
    const Result connected = DirectionField(surface).Compute(Merging(MergePoints::Off));
    EXPECT_TRUE(connected.Notes.empty());
    const Surface soup = Soup(surface);
    const Result merged = DirectionField(soup).Compute(Merging(MergePoints::On));
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
  const Result result = DirectionField(squares).Compute(Merging(MergePoints::On));
  EXPECT_EQ(result.Repaired.NonManifoldPoints, 1);
  EXPECT_EQ(result.Components.size(), 2u);
  // Points 8 and 9 are there for the two fans.
  EXPECT_EQ(result.OriginalPoint.size(), 18u);
  const Result shared = DirectionField(glued).Compute(Merging(MergePoints::On));
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
  const Result result = DirectionField(surface).Compute(Merging(MergePoints::On));
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
  const Result other = DirectionField(surface).Compute(Merging(MergePoints::On));
  EXPECT_EQ(other.Representation, result.Representation);
}

TEST(MergePoints, TheSwitchTakesEffectOnTheNextCall)
{
  const Surface soup = Soup(Potato(1));
  DirectionField field(soup);
  for (const MergePoints merge : { MergePoints::Off, MergePoints::On, MergePoints::On,
         MergePoints::Off, MergePoints::Automatic, MergePoints::Off })
  {
    const Result result = field.Compute(Merging(merge));
    const Result fresh = DirectionField(soup).Compute(Merging(merge));
    EXPECT_EQ(result.Representation, fresh.Representation);
    EXPECT_EQ(result.Components.size(), merge == MergePoints::Off ? 80u : 1u);
  }
}

TEST(MergePoints, GuidanceIsThatOfTheFirstPointThatHasAny)
{
  const Surface surface = Disk(4);
  const Surface soup = Soup(surface);
  Options options = Merging(MergePoints::On);
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
  { return DirectionField(surface).Compute(Merging(MergePoints::Off)).Notes; };
  const Surface triangle{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  for (const Surface& surface : { triangle, Square(5), Potato(1), Cylinder(8, 3, 1.0) })
  {
    EXPECT_TRUE(notes(surface).empty());
  }
  ASSERT_EQ(notes(Soup(Tetrahedron())).size(), 1u);
  EXPECT_EQ(notes(Soup(Tetrahedron()))[0].rfind("12 of the 12 points", 0), 0u);
  EXPECT_NE(notes(Soup(Tetrahedron()))[0].find("Merge Points"), std::string::npos);
  // Two squares of 16 boundary points each that touch along a side of 5 points, 10 of 32: a seam.
  EXPECT_TRUE(
    notes(Joined(Square(4), Transformed(Square(4), Eigen::Matrix3d::Identity(), { 1, 0, 0 })))
      .empty());
  // Of 2 triangles: 4 of 6.
  EXPECT_EQ(notes(Soup(Square(1))).size(), 1u);
}

namespace
{
/// How many components there are where points that coincide along seams are merged.
std::size_t ComponentsAcrossSeams(const Surface& surface)
{
  const Result result = DirectionField(surface).Compute(Merging(MergePoints::Automatic));
  EXPECT_TRUE(result.Notes.empty());
  return result.Components.size();
}

Surface Shifted(const Surface& surface, const Vector3& shift)
{
  return Transformed(surface, Eigen::Matrix3d::Identity(), shift);
}

Surface Rewound(Surface surface)
{
  for (Triangle& t : surface.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return surface;
}
}

TEST(MergePoints, AutomaticConnectsSoupAsOnDoes)
{
  EXPECT_EQ(Options().MergePoints, MergePoints::Automatic);
  for (const Surface& surface :
    { Potato(2), Torus(12, 8), Joined(Cube(), Disk(4)), MoebiusStrip(12, 2) })
  {
    const Surface soup = Soup(surface);
    const Result on = DirectionField(soup).Compute(Merging(MergePoints::On));
    const Result automatic = DirectionField(soup).Compute(Merging(MergePoints::Automatic));
    EXPECT_TRUE(automatic.Notes.empty());
    EXPECT_EQ(automatic.Representation, on.Representation);
    EXPECT_EQ(automatic.SingularityIndex, on.SingularityIndex);
    EXPECT_EQ(automatic.OriginalPoint, on.OriginalPoint);
    const auto merged = static_cast<Index>(soup.Points.size() - surface.Points.size());
    EXPECT_EQ(automatic.Repaired.MergedPoints, merged);
    // The cube and the disk touch.
    EXPECT_GE(on.Repaired.MergedPoints, merged);
  }
}

TEST(MergePoints, AutomaticLeavesASurfaceThatIsConnectedAlone)
{
  for (const Surface& surface : { Potato(2), Square(5), Disk(4), Cylinder(8, 3, 1.0),
         MoebiusStrip(12, 2), Joined(Cube(), Shifted(Cube(), { 0.5, 0, 0 })) })
  {
    EXPECT_TRUE(FirstAcrossSeams(TriangleMesh(surface), surface.Points).empty());
    const Result off = DirectionField(surface).Compute(Merging(MergePoints::Off));
    const Result automatic = DirectionField(surface).Compute(Merging(MergePoints::Automatic));
    EXPECT_EQ(automatic.Representation, off.Representation);
    EXPECT_EQ(automatic.Repaired.MergedPoints, 0);
  }
}

TEST(MergePoints, AutomaticClosesSeams)
{
  // A torus cut along two circles, as textures cut it: a grid whose last row and column repeat the
  // first.
  const Surface torus = Torus(16, 10);
  const auto place = [](Index i, Index j) { return 16 * (j % 10) + i % 16; };
  Surface cut;
  for (Index j = 0; j <= 10; ++j)
  {
    for (Index i = 0; i <= 16; ++i)
    {
      cut.Points.push_back(torus.Points[place(i, j)]);
    }
  }
  for (Index j = 0; j < 10; ++j)
  {
    for (Index i = 0; i < 16; ++i)
    {
      const Index a = 17 * j + i;
      cut.Triangles.push_back({ a, a + 1, a + 18 });
      cut.Triangles.push_back({ a, a + 18, a + 17 });
    }
  }
  const Result closed = DirectionField(cut).Compute(Merging(MergePoints::Automatic));
  ASSERT_EQ(closed.Components.size(), 1u);
  EXPECT_TRUE(closed.Components[0].Closed);
  EXPECT_EQ(closed.Components[0].EulerCharacteristic, 0);
  EXPECT_EQ(closed.Repaired.MergedPoints, 17 * 11 - 16 * 10);
  EXPECT_FALSE(DirectionField(cut).Compute(Merging(MergePoints::Off)).Components[0].Closed);
  // Patches side by side, whichever way they are wound.
  const Surface patch = Square(4);
  EXPECT_EQ(ComponentsAcrossSeams(Joined(patch, Shifted(patch, { 1, 0, 0 }))), 1u);
  EXPECT_EQ(ComponentsAcrossSeams(Joined(patch, Rewound(Shifted(patch, { 1, 0, 0 })))), 1u);
}

TEST(MergePoints, AutomaticLeavesApartWhatOnlyTouches)
{
  const Surface patch = Square(4);
  // In a corner, and three or four along an edge.
  EXPECT_EQ(ComponentsAcrossSeams(Joined(patch, Shifted(patch, { 1, 1, 0 }))), 2u);
  const Eigen::Matrix3d up = Eigen::AngleAxisd(0.5 * Pi, Vector3::UnitY()).toRotationMatrix();
  const Surface standing = Transformed(patch, up, { 1, 0, 1 });
  const Surface three =
    Joined(Joined(patch, Shifted(patch, { 1, 0, 0 })), Shifted(standing, { 0, 0, 0 }));
  EXPECT_EQ(ComponentsAcrossSeams(three), 3u);
  // Bodies that meet in a point or an edge, closed or as soup; each stays closed.
  const Surface cube = Cube();
  Vector3 low = cube.Points[0];
  Vector3 high = low;
  for (const Vector3& p : cube.Points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3 side = high - low;
  for (const Vector3& shift : { side, Vector3(side.x(), side.y(), 0.0) })
  {
    const Surface bodies = Joined(cube, Shifted(cube, shift));
    for (const Surface& surface : { bodies, Soup(bodies) })
    {
      const Result result = DirectionField(surface).Compute(Merging(MergePoints::Automatic));
      ASSERT_EQ(result.Components.size(), 2u);
      EXPECT_TRUE(result.Components[0].Closed && result.Components[1].Closed);
      EXPECT_EQ(result.Repaired.NonManifoldEdges, 0);
      EXPECT_EQ(result.Repaired.NonManifoldPoints, 0);
    }
  }
  // A sheet that is there twice, whichever way the second is wound, is no pillow.
  EXPECT_EQ(ComponentsAcrossSeams(Joined(patch, patch)), 2u);
  EXPECT_EQ(ComponentsAcrossSeams(Joined(patch, Rewound(patch))), 2u);
}

TEST(MergePoints, AutomaticMakesOnePointOfAHoleThatIsNone)
{
  // A disk of a ring of quads, the inner points of which are all in its middle, and another ring.
  constexpr int sides = 12;
  Surface disk;
  for (int k = 0; k < sides; ++k)
  {
    for (const double r : { 0.0, 1.0, 2.0 })
    {
      disk.Points.emplace_back(
        r * std::cos(2.0 * Pi * k / sides), r * std::sin(2.0 * Pi * k / sides), 0.0);
    }
  }
  for (int k = 0; k < sides; ++k)
  {
    const Index a = 3 * k;
    const Index b = 3 * ((k + 1) % sides);
    for (const Index r : { 0, 1 })
    {
      disk.Triangles.push_back({ a + r, a + r + 1, b + r + 1 });
      disk.Triangles.push_back({ a + r, b + r + 1, b + r });
    }
  }
  const TriangleMesh apart(disk);
  const std::vector<Index> first = Internal::FirstAcrossSeams(apart, disk.Points);
  ASSERT_EQ(first.size(), disk.Points.size());
  for (std::size_t p = 0; p < first.size(); ++p)
  {
    EXPECT_EQ(first[p], p % 3 == 0 ? 0 : static_cast<Index>(p));
  }
  const TriangleMesh mesh = Internal::MergedMesh::AcrossSeams(disk).Mesh;
  EXPECT_EQ(mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles(), 1);
  EXPECT_EQ(mesh.GetNumberOfVertices(), 1 + 2 * sides);
}

TEST(MergePoints, AutomaticIgnoresTrianglesWithoutPlaces)
{
  // A sliver between two facets of a soup whose corners are at two places.
  Surface soup = Soup(Tetrahedron());
  const auto first = static_cast<Index>(soup.Points.size());
  soup.Points.push_back(soup.Points[0]);
  soup.Points.push_back(soup.Points[1]);
  soup.Points.push_back(soup.Points[0]);
  soup.Triangles.push_back({ first, first + 1, first + 2 });
  const Result result = DirectionField(soup).Compute(Merging(MergePoints::Automatic));
  ASSERT_EQ(result.Components.size(), 1u);
  EXPECT_TRUE(result.Components[0].Closed);
  EXPECT_EQ(result.Repaired.CollapsedTriangles, 1);
}
