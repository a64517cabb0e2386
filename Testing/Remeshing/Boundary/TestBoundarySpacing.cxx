// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundaryEdits.h"
#include "Boundary/BoundaryMatch.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"
#include "Reports/RemeshReports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Place = std::array<double, 3>;

/// The points at ends of edges that one of the faces has only.
template <typename Face>
std::vector<Vector3> BoundaryPoints(
  const std::vector<Vector3>& points, const std::vector<Face>& faces)
{
  std::map<std::array<Index, 2>, int> times;
  for (const Face& face : faces)
  {
    std::vector<Index> corners;
    std::copy_if(face.begin(), face.end(), std::back_inserter(corners),
      [](Index corner) { return corner != None; });
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      const Index a = corners[c];
      const Index b = corners[(c + 1) % corners.size()];
      ++times[{ std::min(a, b), std::max(a, b) }];
    }
  }
  std::set<Index> boundary;
  for (const auto& [ends, faces_] : times)
  {
    if (faces_ == 1)
    {
      boundary.insert(ends.begin(), ends.end());
    }
  }
  std::vector<Vector3> places;
  for (const Index v : boundary)
  {
    places.push_back(points[v]);
  }
  return places;
}

/// The largest distance of one of the first points from the nearest of the others.
double Farthest(const std::vector<Vector3>& points, const std::vector<Vector3>& others)
{
  double farthest = 0.0;
  for (const Vector3& p : points)
  {
    double nearest = 1e300;
    for (const Vector3& q : others)
    {
      nearest = std::min(nearest, (p - q).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

RemeshResult Meshed(const Surface& surface, Index faces, BoundarySpacing spacing, bool isPure)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.BoundarySpacing = spacing;
  options.PureQuads = isPure;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

struct Example
{
  const char* Name;
  Surface Given;
  Index Faces;
  bool IsOneSided = false;
};

/// Boundaries with and without corners, finer and coarser than the wanted faces, even and uneven.
std::vector<Example> Examples()
{
  Surface uneven = Meshes::Square(24);
  for (Vector3& p : uneven.Points)
  {
    p.x() = p.x() * (0.4 + 0.6 * p.x());
  }
  return { { "square", Meshes::Square(20), 400 }, { "fine square", Meshes::Square(40), 400 },
    { "coarse square", Meshes::Square(12), 600 }, { "uneven square", uneven, 500 },
    { "disk", Meshes::Disk(12), 500 }, { "plate", Meshes::PlateWithHole(48, 8, 0.4, false), 800 },
    { "bent plate", Meshes::PlateWithHole(48, 8, 0.4, true), 800 },
    { "hemisphere", Meshes::Hemisphere(4), 700 },
    { "cylinder", Meshes::Cylinder(40, 12, 2.0), 600 }, { "L", Meshes::LShape(16), 500 },
    { "Moebius", Meshes::MoebiusStrip(60, 8), 400, true } };
}
}

TEST(BoundarySpacing, KeepHasThePointsOfTheBoundaryAndNoOthers)
{
  for (const Example& example : Examples())
  {
    for (const bool isPure : { false, true })
    {
      SCOPED_TRACE(std::string(example.Name) + (isPure ? ", pure" : ""));
      const RemeshResult mesh = Meshed(example.Given, example.Faces, BoundarySpacing::Keep, isPure);
      const std::vector<Vector3> given =
        BoundaryPoints(example.Given.Points, example.Given.Triangles);
      const std::vector<Vector3> made = BoundaryPoints(mesh.Points, mesh.Faces);
      EXPECT_LE(Farthest(given, made), 1e-12);
      EXPECT_LE(Farthest(made, given), 1e-12);
      EXPECT_EQ(made.size(), given.size());
      EXPECT_EQ(mesh.Boundary.Points, mesh.Boundary.Kept);
      EXPECT_EQ(mesh.Boundary.Others, 0);
      EXPECT_EQ(mesh.EulerCharacteristicBefore, mesh.EulerCharacteristicAfter);
      if (isPure)
      {
        EXPECT_EQ(mesh.Triangles, 0);
      }
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.35);
      EXPECT_TRUE(example.IsOneSided || Meshes::FlawOf(mesh).empty()) << Meshes::FlawOf(mesh);
    }
  }
}

TEST(BoundarySpacing, EvenEdgesAreOfOneLength)
{
  for (const Example& example : Examples())
  {
    for (const bool isPure : { false, true })
    {
      SCOPED_TRACE(std::string(example.Name) + (isPure ? ", pure" : ""));
      const RemeshResult mesh = Meshed(example.Given, example.Faces, BoundarySpacing::Even, isPure);
      EXPECT_LE(mesh.Boundary.Unevenness, 0.02);
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.35);
      EXPECT_TRUE(example.IsOneSided || Meshes::FlawOf(mesh).empty()) << Meshes::FlawOf(mesh);
      EXPECT_NE(Summary(mesh, {}).find("edges of the boundary even to"), std::string::npos);
    }
  }
}

/// Oblique strips whose borders are stairs of the triangles leave little room at the boundary: no
/// face is folded, for they are made for the places where the vertices are at the end.
TEST(BoundarySpacing, StripsThatRunInStairsHaveNoFoldedFacesWithEvenEdges)
{
  Surface plate = Meshes::Square(60, 2.0);
  plate.Triangles.erase(std::remove_if(plate.Triangles.begin(), plate.Triangles.end(),
                          [&](const Triangle& t) {
                            return std::max(plate.Points[t[0]].y(), plate.Points[t[2]].y()) > 1.01;
                          }),
    plate.Triangles.end());
  RemeshOptions options;
  for (const Triangle& t : plate.Triangles)
  {
    const Vector3 middle = (plate.Points[t[0]] + plate.Points[t[1]] + plate.Points[t[2]]) / 3.0;
    options.Regions.push_back(static_cast<Index>(2.0 * middle.x() + 0.6 * middle.y()));
  }
  options.NumberOfFaces = 300;
  options.BoundarySpacing = BoundarySpacing::Even;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(plate)).Compute(options);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.25);
  EXPECT_LE(mesh.Boundary.Unevenness, 0.001);
}

/// One vertex that is off its place does not turn the others around a circle: the angles of all
/// have the mean that they had, and differ by the same.
TEST(BoundaryEdits, EvenEdgesAroundAHoleTurnByNothingInTheMean)
{
  const Surface disk = Meshes::Disk(40);
  const std::vector<BoundaryLine> lines =
    BoundaryLinesOf(disk, std::vector<char>(disk.Triangles.size(), 1));
  constexpr Index sides = 16;
  const double step = std::acos(-1.0) / 8.0;
  for (const Index moved : { 0, 5 })
  {
    FaceMesh fan;
    double sum = 0.0;
    for (Index k = 0; k < sides; ++k)
    {
      const double angle = step * (static_cast<double>(k) + (k == moved ? 0.4 : 0.0));
      sum += angle;
      fan.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
      fan.Vertices.emplace_back();
      fan.Vertices.back().Line = 1;
      fan.Vertices.back().IsBoundary = true;
      fan.LineEdges.push_back({ { k, (k + 1) % sides }, 1 });
      fan.Cells.Corners.push_back({ k, (k + 1) % sides, sides, None });
      fan.Cells.IsRegular.push_back(1);
    }
    fan.Points.emplace_back(0.0, 0.0, 0.0);
    fan.Vertices.emplace_back();
    SpaceBoundary(fan, disk, lines, {}, false);
    for (Index k = 0; k < sides; ++k)
    {
      const double angle = step * static_cast<double>(k) + (sum - 120.0 * step) / sides;
      const Vector3 wanted(std::cos(angle), std::sin(angle), 0.0);
      EXPECT_LE((fan.Points[k] - wanted).norm(), 0.01 * step) << k;
    }
  }
}

/// The figure is that of the edges themselves: around a disk there are no corners.
TEST(BoundarySpacing, EvenEdgesAreEqualInSpace)
{
  const Surface disk = Meshes::Disk(14);
  const auto spread = [&](BoundarySpacing spacing)
  {
    std::vector<Vector3> around = BoundaryPoints(disk.Points, disk.Triangles);
    const RemeshResult mesh = Meshed(disk, 350, spacing, true);
    around = BoundaryPoints(mesh.Points, mesh.Faces);
    std::sort(around.begin(), around.end(),
      [](const Vector3& a, const Vector3& b)
      { return std::atan2(a.y(), a.x()) < std::atan2(b.y(), b.x()); });
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < around.size(); ++k)
    {
      const double length = (around[k] - around[(k + 1) % around.size()]).norm();
      sum += length;
      squares += length * length;
    }
    const auto count = static_cast<double>(around.size());
    return std::sqrt(std::max(0.0, squares * count / (sum * sum) - 1.0));
  };
  EXPECT_GT(spread(BoundarySpacing::Free), 0.02);
  EXPECT_LT(spread(BoundarySpacing::Even), 1e-6);
}

/// Quads have an even number of edges around them: a triangle is left at an odd boundary.
TEST(BoundarySpacing, SaysWhyATriangleIsLeft)
{
  Surface square = Meshes::Square(10);
  // Cuts a corner off, which has two edges there.
  const auto isCorner = [&](const Triangle& t)
  {
    return std::any_of(t.begin(), t.end(), [&](Index p) { return square.Points[p].isZero(0.0); }) &&
      std::count_if(t.begin(), t.end(),
        [&](Index p) { return square.Points[p].x() * square.Points[p].y() == 0.0; }) == 3;
  };
  const auto cut = std::find_if(square.Triangles.begin(), square.Triangles.end(), isCorner);
  if (cut != square.Triangles.end())
  {
    square.Triangles.erase(cut);
  }
  else
  {
    // One of the triangles at a side.
    square.Triangles.erase(square.Triangles.begin() + 6);
  }
  ASSERT_EQ(BoundaryPoints(square.Points, square.Triangles).size() % 2, 1U);
  const RemeshResult mesh = Meshed(square, 100, BoundarySpacing::Keep, true);
  EXPECT_EQ(mesh.Triangles, 1);
  EXPECT_EQ(mesh.Boundary.Kept, mesh.Boundary.Points);
  EXPECT_TRUE(std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
    [](const std::string& note)
    { return note.find("1 triangle is left among the quads, one in each component") == 0; }));
}

TEST(BoundarySpacing, SaysThatThereIsNoBoundary)
{
  for (const BoundarySpacing spacing : { BoundarySpacing::Even, BoundarySpacing::Keep })
  {
    const RemeshResult mesh = Meshed(Meshes::Icosphere(3), 200, spacing, false);
    EXPECT_TRUE(std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
      [](const std::string& note) { return note.find("The surface has no boundary") == 0; }));
  }
}

/// Meshes of triangles keep the boundary alike, and so do surfaces far from 0.
TEST(BoundarySpacing, KeepsItAroundTrianglesAndFarAway)
{
  RemeshOptions options;
  options.NumberOfFaces = 400;
  options.BoundarySpacing = BoundarySpacing::Keep;
  options.Element = Element::Triangles;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(Meshes::Disk(10))).Compute(options);
  EXPECT_EQ(mesh.Boundary.Kept, 60);
  EXPECT_EQ(mesh.Boundary.Others, 0);
  const Surface far = Meshes::Transformed(
    Meshes::Disk(10), 1e-3 * Eigen::Matrix3d::Identity(), Vector3(1e3, -2e3, 0.0));
  const RemeshResult moved = Meshed(far, 400, BoundarySpacing::Keep, false);
  EXPECT_LE(
    Farthest(BoundaryPoints(far.Points, far.Triangles), BoundaryPoints(moved.Points, moved.Faces)),
    1e-12);
}

/// The vertices of a side become the points that they are nearest to, in their order; without a
/// vertex are as few points as can be.
TEST(BoundaryMatch, TakesTheNearestPoints)
{
  const Surface disk = Meshes::Disk(5);
  const std::vector<BoundaryLine> lines =
    BoundaryLinesOf(disk, std::vector<char>(disk.Triangles.size(), 1));
  ASSERT_EQ(lines.size(), 1U);
  const Index round = lines[0].GetNumberOfEdges();
  ASSERT_EQ(round, 30);
  BoundarySide side;
  side.Line = 0;
  for (Index k = 0; k <= 28; ++k)
  {
    side.Vertices.push_back(k % 28);
    side.Places.push_back(k == 28 ? 30.0 : (k < 10 ? k : k < 20 ? k + 1 : k + 2) + 0.2 * (k % 2));
  }
  const std::vector<Index> match =
    MatchBoundary(side, lines[0], std::vector<char>(side.Vertices.size(), 0));
  for (Index k = 0; k <= 28; ++k)
  {
    EXPECT_EQ(match[k], k < 10 ? k : k < 20 ? k + 1 : k + 2);
  }
}
