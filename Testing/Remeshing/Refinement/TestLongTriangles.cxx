// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoints.h"
#include "Finishing/CloserMesh.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Preparation/WantedSizes.h"
#include "Refinement/FlatFlips.h"
#include "Refinement/LongEdges.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// A prism over a regular polygon as CAD programs write it: two triangles a side, and fans without
/// a point inside at the two ends.
Surface Prism(int sides, double height)
{
  Surface prism;
  for (int k = 0; k < sides; ++k)
  {
    const double a = 2.0 * Pi * k / sides;
    prism.Points.emplace_back(std::cos(a), std::sin(a), 0.0);
    prism.Points.emplace_back(std::cos(a), std::sin(a), height);
  }
  for (int k = 0; k < sides; ++k)
  {
    const Index a = 2 * k;
    const Index b = 2 * ((k + 1) % sides);
    prism.Triangles.push_back({ a, b, b + 1 });
    prism.Triangles.push_back({ a, b + 1, a + 1 });
    if (k > 0 && k + 1 < sides)
    {
      prism.Triangles.push_back({ 0, b, a });
      prism.Triangles.push_back({ 1, a + 1, b + 1 });
    }
  }
  return prism;
}

/// Triangles around one point.
Surface Cone(int sides, double height)
{
  Surface cone;
  cone.Points.emplace_back(0.0, 0.0, height);
  for (int k = 0; k < sides; ++k)
  {
    cone.Points.emplace_back(std::cos(2.0 * Pi * k / sides), std::sin(2.0 * Pi * k / sides), 0.0);
    cone.Triangles.push_back({ 0, k + 1, (k + 1) % sides + 1 });
  }
  return cone;
}

/// A square plate with a round hole of this number of sides, a multiple of 4, without points inside
/// of its two faces.
Surface PlateWithHole(int sides)
{
  Surface plate;
  const auto corner = [](double x, double y) { return Vector3(x, y, 0.0); };
  plate.Points = { corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0) };
  for (int k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * Pi * k / sides - Pi;
    plate.Points.push_back(corner(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle)));
  }
  const auto top = static_cast<Index>(plate.Points.size());
  for (Index v = 0; v < top; ++v)
  {
    plate.Points.push_back(plate.Points[v] + Vector3(0.0, 0.0, 0.2));
  }
  const auto add = [&](Index a, Index b, Index c)
  {
    plate.Triangles.push_back({ a, c, b });
    plate.Triangles.push_back({ a + top, b + top, c + top });
  };
  const auto wall = [&](Index a, Index b)
  {
    plate.Triangles.push_back({ a, b, b + top });
    plate.Triangles.push_back({ a, b + top, a + top });
  };
  for (Index k = 0; k < sides; ++k)
  {
    const Index quarter = 4 * k / sides;
    const Index next = 4 + (k + 1) % sides;
    add(quarter, next, 4 + k);
    wall(next, 4 + k);
    if (4 * (k + 1) % sides == 0)
    {
      add(quarter, (quarter + 1) % 4, next);
      wall(quarter, (quarter + 1) % 4);
    }
  }
  return plate;
}

/// Squares of length 1, each with a round hole of this number of sides, a multiple of 4, and without
/// points beside those of the holes and the corners of the squares.
Surface PlateWithHoles(int across, int along, int sides)
{
  Surface plate;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i <= across; ++i)
    {
      plate.Points.emplace_back(i, j, 0.0);
    }
  }
  for (int hole = 0; hole < across * along; ++hole)
  {
    const int i = hole % across;
    const int j = hole / across;
    const Index corner = j * (across + 1) + i;
    const std::array<Index, 4> corners = { corner, corner + 1, corner + across + 2,
      corner + across + 1 };
    const auto first = static_cast<Index>(plate.Points.size());
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * Pi * k / sides - Pi;
      plate.Points.emplace_back(
        i + 0.5 + 0.25 * std::cos(angle), j + 0.5 + 0.25 * std::sin(angle), 0.0);
      const Index quarter = 4 * k / sides;
      const Index next = first + (k + 1) % sides;
      plate.Triangles.push_back({ corners[quarter], next, first + k });
      if (4 * (k + 1) % sides == 0)
      {
        plate.Triangles.push_back({ corners[quarter], corners[(quarter + 1) % 4], next });
      }
    }
  }
  return plate;
}

/// The mouth and the bottom of the keyway of a hub.
const std::array<Eigen::Vector2d, 4> Keyway = { Eigen::Vector2d(std::sqrt(0.1125), -0.1),
  Eigen::Vector2d(0.5, -0.1), Eigen::Vector2d(0.5, 0.1), Eigen::Vector2d(std::sqrt(0.1125), 0.1) };

/// A round hub of radius 1 with a bore and a keyway in it, in strips from the bore to the rim.
Surface HubWithKeyway(double height)
{
  std::vector<Eigen::Vector2d> bore(Keyway.begin(), Keyway.end());
  constexpr int sides = 24;
  const double half = std::atan2(Keyway[3].y(), Keyway[3].x());
  for (int k = 1; k < sides; ++k)
  {
    const double angle = half + 2.0 * (Pi - half) * k / sides;
    bore.push_back(Keyway[3].norm() * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  Surface hub;
  for (const Eigen::Vector2d& p : bore)
  {
    for (const Eigen::Vector2d& q : { p, Eigen::Vector2d(p.normalized()) })
    {
      hub.Points.emplace_back(q.x(), q.y(), 0.0);
      hub.Points.emplace_back(q.x(), q.y(), height);
    }
  }
  const auto size = static_cast<Index>(hub.Points.size());
  const auto quad = [&](Index a, Index b, Index c, Index d)
  {
    hub.Triangles.push_back({ a, b, c });
    hub.Triangles.push_back({ a, c, d });
  };
  for (Index a = 0; a < size; a += 4)
  {
    const Index b = (a + 4) % size;
    quad(a + 1, a + 3, b + 3, b + 1);
    quad(a, b, b + 2, a + 2);
    quad(b, a, a + 1, b + 1);
    quad(a + 2, b + 2, b + 3, a + 3);
  }
  return hub;
}
}

TEST(LongTriangles, PrismsHaveTheIrregularVerticesOfTheirTwoEnds)
{
  struct Case
  {
    int Sides;
    double Height;
  };
  // The last is a disk: most of its triangles are as long as it is wide.
  for (const Case& one : { Case{ 6, 3.0 }, { 32, 3.0 }, { 200, 3.0 }, { 100, 0.05 } })
  {
    RemeshOptions options;
    options.NumberOfFaces = 2000;
    const RemeshResult mesh =
      Remesh(std::make_shared<Surface>(Prism(one.Sides, one.Height))).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Triangles, 0) << one.Sides;
    EXPECT_EQ(mesh.KeptVertices, 0) << one.Sides;
    EXPECT_EQ(mesh.IrregularVertices, 8) << one.Sides;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.5) << one.Sides;
    EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 2000.0, 200.0) << one.Sides;
  }
}

TEST(LongTriangles, FacesOfAPlateWithAHoleAreEven)
{
  // Rounded greedily, the sides of the hole have other numbers of edges than what is around them.
  RemeshOptions options;
  options.NumberOfFaces = 700;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(PlateWithHole(20))).Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_LE(mesh.Triangles, 7);
  EXPECT_LE(mesh.IrregularVertices, 24);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.5);
}

TEST(LongTriangles, RimsHaveTheirIrregularVerticesAnEdgeAway)
{
  // The field has four singularities at each hole, some of them closer to the rim than an edge, and
  // none where they could be spared: all valences add up to four times Euler's number.
  const auto plate = std::make_shared<Surface>(PlateWithHoles(4, 3, 24));
  for (const Index faces : { 600, 1500 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    const RemeshResult mesh = Remesh(plate).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Triangles, 0) << faces;
    EXPECT_EQ(mesh.IrregularVertices, 4 * 12) << faces;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.5) << faces;
    EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), faces, 0.1 * faces);
  }
}

TEST(LongTriangles, WallsThinnerThanAnEdgeHaveOneRow)
{
  // Between rims that are a quarter of an edge apart, and an eighth, rounding left no row at all.
  const double thickness = 0.02;
  const auto disk = std::make_shared<Surface>(Prism(100, thickness));
  for (const Index faces : { 1000, 300 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    const RemeshResult mesh = Remesh(disk).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_TRUE(mesh.Notes.empty());
    EXPECT_EQ(mesh.Triangles, 0) << faces;
    EXPECT_EQ(mesh.IrregularVertices, 8) << faces;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.5) << faces;
    // All vertices are on the two sides, and the faces between are as many as the edges of a rim.
    std::size_t between = 0;
    for (const Vector3& point : mesh.Points)
    {
      EXPECT_LT(std::min(std::abs(point[2]), std::abs(point[2] - thickness)), 1e-9);
    }
    for (const std::array<Index, 4>& face : mesh.Faces)
    {
      std::size_t above = 0;
      for (const Index v : face)
      {
        above += mesh.Points[v][2] > 0.5 * thickness ? 1 : 0;
      }
      EXPECT_EQ(above % 2, 0U);
      between += above == 2 ? 1 : 0;
    }
    const auto isOnRim = [&](const Vector3& point)
    { return point[2] < 0.5 * thickness && std::hypot(point[0], point[1]) > 0.999; };
    EXPECT_EQ(between, std::count_if(mesh.Points.begin(), mesh.Points.end(), isOnRim));
  }
}

TEST(LongTriangles, FansOfDozensAndThousandsAreRemeshedAsOthers)
{
  struct Case
  {
    int Sides;
    double Height;
    int MostIrregular;
  };
  // A disk has four irregular vertices, where the field says so.
  for (const Case& one :
    { Case{ 60, 2.0, 6 }, { 300, 0.0, 4 }, { 3000, 0.0, 4 }, { 1000, 1.0, 40 } })
  {
    RemeshOptions options;
    options.NumberOfFaces = 2000;
    const RemeshResult mesh =
      Remesh(std::make_shared<Surface>(Cone(one.Sides, one.Height))).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_LE(mesh.IrregularVertices, one.MostIrregular) << one.Sides;
    EXPECT_LT(mesh.Triangles, 10) << one.Sides;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.2) << one.Sides;
    EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 2000.0, 200.0) << one.Sides;
  }
}

TEST(LongTriangles, FlatConesWithABaseHaveTheIrregularVerticesOfTwoDisks)
{
  // Of their area a little less than half is the base, which alone is in a plane.
  for (const auto& [sides, height] :
    { std::pair(12, 0.2), std::pair(12, 1.0), std::pair(20, 0.2), std::pair(20, 1.0) })
  {
    Surface cone = Cone(sides, height);
    for (int k = 1; k + 1 < sides; ++k)
    {
      cone.Triangles.push_back({ 1, k + 2, k + 1 });
    }
    RemeshOptions options;
    options.NumberOfFaces = 1000;
    const RemeshResult mesh = Remesh(std::make_shared<Surface>(cone)).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.IrregularVertices, 8) << sides << " " << height;
    EXPECT_EQ(mesh.Triangles, 0) << sides << " " << height;
    EXPECT_EQ(mesh.TurnedFaces, 0) << sides << " " << height;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.5) << sides << " " << height;
  }
}

TEST(LongTriangles, NoEdgeOfAPreparedSurfaceIsLongerThanItMayBe)
{
  const Surface prism = Prism(50, 4.0);
  const double area = RelativeArea(prism, std::vector<double>(prism.Points.size(), 1.0));
  const double wanted = std::sqrt(area / 2000.0);
  WorkingLengths lengths =
    LengthsFor(prism, std::vector<double>(prism.Points.size(), 1.0), area, wanted);
  EXPECT_GT(lengths.MostMiddles, 2000);
  EXPECT_LT(lengths.MostMiddles, 10000);
  lengths.MostMiddles = 100000;
  const PreparedSurface prepared(prism, 4, FeatureSettings{ true, 40.0, 0.5, 0.0 }, lengths);
  const SurfaceGeometry& geometry = prepared.GetGeometry();
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = geometry.Mesh.HalfEdge(e);
    EXPECT_LT(
      (geometry.Positions[geometry.Mesh.Head(h)] - geometry.Positions[geometry.Mesh.Tail(h)])
        .norm(),
      2.0 * wanted);
  }
  // Edges of the ends are features still.
  const std::vector<char> isFeature = prepared.FindFeatures({ true, 40.0, 0.5, 0.0 });
  EXPECT_GE(std::count(isFeature.begin(), isFeature.end(), 1), 2 * 50);
}

TEST(LongTriangles, ThereAreNoMoreOfThemThanThereIsRoomFor)
{
  const Surface prism = Prism(50, 4.0);
  const SurfaceGeometry geometry(prism);
  const std::vector<double> longest(prism.Points.size(), 0.5);
  const auto count = [&](Index room)
  {
    const std::vector<char> isLong = FindLongEdges(geometry, longest, room);
    return std::count(isLong.begin(), isLong.end(), 1);
  };
  EXPECT_GT(count(1000), 100);
  EXPECT_LE(count(20), 20);
  EXPECT_EQ(count(0), 0);
}

TEST(LongTriangles, TrianglesOfBentSurfacesAreNotSplit)
{
  EXPECT_FALSE(IsMostlyFlat(SurfaceGeometry(Meshes::Potato(2))));
  EXPECT_TRUE(IsMostlyFlat(SurfaceGeometry(Prism(50, 4.0))));
}

TEST(LongTriangles, FlipsMakePlanesDelaunayAndLeaveFoldsAlone)
{
  // Two long triangles, flat or folded along their common edge.
  for (const double height : { 0.0, 0.5 })
  {
    Surface kite;
    kite.Points = { { -4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 1.0, height },
      { 0.0, -1.0, height } };
    kite.Triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
    const SurfaceGeometry geometry(kite);
    const std::vector<char> isFixed(geometry.Mesh.GetNumberOfEdges(), 0);
    const std::vector<double> longest(4, 1.0);
    bool isTurned = true;
    for (const Triangle& t : FlipFlat(geometry, isFixed, longest))
    {
      isTurned = isTurned && std::count(t.begin(), t.end(), 2) == 1 &&
        std::count(t.begin(), t.end(), 3) == 1;
    }
    EXPECT_EQ(isTurned, height == 0.0);
    // An edge that is fixed stays.
    const std::vector<char> all(geometry.Mesh.GetNumberOfEdges(), 1);
    EXPECT_EQ(FlipFlat(geometry, all, longest), kite.Triangles);
  }
}

TEST(LongTriangles, KeywaysKeepTheirEdges)
{
  for (const double height : { 0.3, 0.5 })
  {
    for (const Index faces : { 1500, 2000 })
    {
      RemeshOptions options;
      options.NumberOfFaces = faces;
      const RemeshResult mesh =
        Remesh(std::make_shared<Surface>(HubWithKeyway(height))).Compute(options);
      std::vector<ClosestPoints::Corners> edges;
      for (const auto& face : mesh.Faces)
      {
        const std::size_t corners = face[3] == None ? 3 : 4;
        for (std::size_t c = 0; c < corners; ++c)
        {
          const Vector3& end = mesh.Points[face[(c + 1) % corners]];
          edges.push_back({ mesh.Points[face[c]], end, end });
        }
      }
      const ClosestPoints closest(std::move(edges));
      double farthest = 0.0;
      for (const double z : { 0.0, height })
      {
        for (std::size_t side = 0; side < 3; ++side)
        {
          for (const double part : { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 })
          {
            const Eigen::Vector2d p = (1.0 - part) * Keyway[side] + part * Keyway[side + 1];
            farthest =
              std::max(farthest, std::sqrt(closest.Find(Vector3(p.x(), p.y(), z)).SquaredDistance));
          }
        }
      }
      EXPECT_LT(farthest, 1e-6) << faces << " faces, height " << height;
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.6);
    }
  }
}

TEST(LongTriangles, MeshesWithFacesOfNoUseAreMadeAnew)
{
  // The first mesh has faces without area between the rim and the singularities beside it.
  RemeshOptions options;
  options.NumberOfFaces = 250;
  std::vector<double> progress;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(PlateWithHole(48)))
                              .Compute(options, {},
                                [&](double done)
                                {
                                  progress.push_back(done);
                                  return true;
                                });
  EXPECT_GT(LeastQuality(mesh.Points, mesh.Faces), 0.3);
  EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 250.0, 50.0);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_LE(progress.back(), 1.0);
}

TEST(LongTriangles, ProgressGoesOnWhereAFieldIsComputedAgain)
{
  // The first solver of the prism's field gives up.
  RemeshOptions options;
  options.NumberOfFaces = 1000;
  std::vector<double> progress;
  Remesh(std::make_shared<Surface>(Prism(200, 4.0)))
    .Compute(options, {},
      [&](double done)
      {
        progress.push_back(done);
        return true;
      });
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
}
