// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleMesh.h"
#include "Soup/PolygonEars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <random>

using namespace DirectionFields;

namespace
{
using Corners = std::vector<Vector3>;

/// A closed line around the origin.
Corners Ring(Index number, const std::function<double(Index)>& radius)
{
  Corners ring;
  for (Index i = 0; i < number; ++i)
  {
    const double angle = 2.0 * Pi * i / number;
    ring.emplace_back(radius(i) * Vector3(std::cos(angle), std::sin(angle), 0.0));
  }
  return ring;
}

Corners Moved(Corners corners, const Vector3& by)
{
  for (Vector3& corner : corners)
  {
    corner += by;
  }
  return corners;
}

/// The outline with holes joined to it by bridges, each from the corner of the outline that is
/// given to the hole's first one; ids of the corners, so that both visits of a place have the same.
struct Keyhole
{
  Corners Points;
  std::vector<Index> Ids;

  explicit Keyhole(const Corners& outline)
    : Points(outline)
  {
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      this->Ids.push_back(static_cast<Index>(i));
    }
  }

  void Cut(Index from, const Corners& hole)
  {
    const auto first = static_cast<Index>(this->Points.size());
    const auto size = static_cast<Index>(hole.size());
    this->Points.insert(this->Points.end(), hole.begin(), hole.end());
    auto at = std::find(this->Ids.begin(), this->Ids.end(), from);
    // Clockwise, and back to where it starts.
    std::vector<Index> way = { first };
    for (Index k = size - 1; k >= 0; --k)
    {
      way.push_back(first + k);
    }
    way.push_back(from);
    this->Ids.insert(at + 1, way.begin(), way.end());
  }

  Corners Places() const
  {
    Corners places;
    for (const Index id : this->Ids)
    {
      places.push_back(this->Points[id]);
    }
    return places;
  }
};

double AreaOf(const Corners& corners, const std::vector<Index>& triangles)
{
  double area = 0.0;
  for (std::size_t k = 0; k < triangles.size(); k += 3)
  {
    const Vector3& a = corners[triangles[k]];
    area += 0.5 * (corners[triangles[k + 1]] - a).cross(corners[triangles[k + 2]] - a).z();
  }
  return area;
}

double AreaOf(const Corners& polygon)
{
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    area += 0.5 * polygon[i].cross(polygon[(i + 1) % polygon.size()]).z();
  }
  return area;
}

/// The triangles cover the polygon once: there are as many as there should be, all are wound as it
/// is and have areas that add up to its own.
void ExpectCovered(const Corners& corners, const std::vector<Index>& triangles)
{
  ASSERT_EQ(triangles.size(), 3 * (corners.size() - 2));
  for (std::size_t k = 0; k < triangles.size(); k += 3)
  {
    EXPECT_GT(AreaOf(corners, { triangles[k], triangles[k + 1], triangles[k + 2] }), 0.0);
  }
  const double area = AreaOf(corners);
  EXPECT_NEAR(AreaOf(corners, triangles), area, 1e-9 * area);
}

/// The mesh of the triangles, whose corners are numbered by ids.
TriangleMesh MeshOf(const Keyhole& keyhole, const std::vector<Index>& triangles)
{
  Surface surface;
  surface.Points = keyhole.Points;
  for (std::size_t k = 0; k < triangles.size(); k += 3)
  {
    surface.Triangles.push_back(
      { keyhole.Ids[triangles[k]], keyhole.Ids[triangles[k + 1]], keyhole.Ids[triangles[k + 2]] });
  }
  return TriangleMesh(surface);
}

/// A disk with the given number of holes.
void ExpectHoles(const Keyhole& keyhole, int holes)
{
  const std::vector<Index> triangles = CutEars(keyhole.Places(), false);
  ExpectCovered(keyhole.Places(), triangles);
  const TriangleMesh mesh = MeshOf(keyhole, triangles);
  ASSERT_EQ(mesh.GetComponents().size(), 1u);
  EXPECT_EQ(mesh.GetRepairs().CollapsedTriangles, 0);
  EXPECT_EQ(mesh.GetRepairs().NonManifoldEdges, 0);
  EXPECT_EQ(mesh.GetRepairs().NonManifoldPoints, 0);
  EXPECT_EQ(mesh.GetRepairs().ReversedTriangles, 0);
  EXPECT_EQ(
    mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles(), 1 - holes);
}
}

TEST(PolygonEars, CoverThePolygonOnce)
{
  std::mt19937 engine(7);
  const auto random = [&engine](Index) { return 0.3 + engine() / 4294967296.0; };
  for (const Index number : { 4, 5, 7, 12, 40, 301, 2000 })
  {
    for (const Corners& corners : { Ring(number, [](Index) { return 1.0; }), Ring(number, random),
           Ring(number, [](Index i) { return i % 2 == 0 ? 1.0 : 0.9; }),
           Ring(number, [](Index i) { return 1.0 + 1e-13 * (i % 3); }) })
    {
      const std::vector<Index> triangles = CutEars(corners, false);
      ExpectCovered(corners, triangles);
      // However the polygon is turned around and wherever it is.
      Corners turned = Moved(corners, { 3.0, -5.0, 0.0 });
      std::rotate(turned.begin(), turned.begin() + number / 2, turned.end());
      ExpectCovered(turned, CutEars(turned, false));
      for (Vector3& corner : turned)
      {
        corner *= 1e150;
      }
      EXPECT_EQ(CutEars(turned, false).size(), triangles.size());
    }
  }
  // Many corners on one line.
  Corners comb;
  for (int i = 0; i <= 50; ++i)
  {
    comb.emplace_back(i, 0.0, 0.0);
  }
  for (int i = 50; i >= 0; --i)
  {
    comb.emplace_back(i, i % 2 == 0 ? 10.0 : 1.0, 0.0);
  }
  ExpectCovered(comb, CutEars(comb, false));
}

TEST(PolygonEars, KeepHolesOpen)
{
  const auto round = [](double radius) { return [radius](Index) { return radius; }; };
  for (const Index outer : { 3, 4, 8, 30 })
  {
    for (const Index inner : { 3, 4, 5, 17 })
    {
      for (Index from = 0; from < outer; from += 1 + outer / 4)
      {
        // The bridge is short where it starts at corner 0, and oblique elsewhere.
        Keyhole keyhole(Ring(outer, round(1.0)));
        Corners hole = Ring(inner, round(0.2));
        const double angle = 2.0 * Pi * from / outer;
        for (Vector3& corner : hole)
        {
          corner = { corner.x() * std::cos(angle) - corner.y() * std::sin(angle),
            corner.x() * std::sin(angle) + corner.y() * std::cos(angle), 0.0 };
        }
        keyhole.Cut(from, hole);
        ExpectHoles(keyhole, 1);
      }
    }
  }
  // Holes at one corner, at several, and behind another hole.
  Keyhole several(Ring(16, round(1.0)));
  several.Cut(0, Moved(Ring(4, round(0.1)), { 0.5, 0.4, 0.0 }));
  several.Cut(0, Moved(Ring(5, round(0.1)), { 0.7, 0.0, 0.0 }));
  Corners left = Moved(Ring(6, round(0.1)), { -0.6, 0.0, 0.0 });
  std::rotate(left.begin(), left.begin() + 3, left.end());
  several.Cut(8, left);
  Corners behind = Moved(Ring(3, round(0.1)), { -0.3, 0.0, 0.0 });
  std::rotate(behind.begin(), behind.begin() + 1, behind.end());
  several.Cut(16 + 9 + 3, behind);
  ExpectHoles(several, 4);
  // A square frame, whose bridge and corners are on lines with each other.
  Keyhole frame({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 } });
  frame.Cut(0, { { 1, 1, 0 }, { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 } });
  ExpectHoles(frame, 1);
  // The same turned in space, where lines are straight up to rounding only: no triangle without
  // area.
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  Corners places = frame.Places();
  for (int i = 0; i < 3; ++i)
  {
    places.emplace_back(0.0, 0.75 * (3 - i), 0.0);
  }
  for (Vector3& place : places)
  {
    place = turn * place / 3.0;
  }
  const std::vector<Index> triangles = CutEars(places, false);
  ASSERT_EQ(triangles.size(), 3 * (places.size() - 2));
  for (std::size_t k = 0; k < triangles.size(); k += 3)
  {
    const Vector3& a = places[triangles[k]];
    EXPECT_GT((places[triangles[k + 1]] - a).cross(places[triangles[k + 2]] - a).norm(), 0.01);
  }
}

TEST(PolygonEars, LoopsAtAPlaceAreCutEach)
{
  // Two triangles at a place, then a square with one that goes out of its corner.
  const Corners two = { { 0, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { 0, 0, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  std::vector<Index> triangles = CutEars(two, false);
  EXPECT_EQ(triangles.size(), 6u);
  EXPECT_NEAR(AreaOf(two, triangles), 2.0, 1e-12);
  const Corners corner = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 1, 0 }, { 2, 2, 0 },
    { 1, 1, 0 }, { 0, 1, 0 } };
  triangles = CutEars(corner, false);
  EXPECT_EQ(triangles.size(), 9u);
  EXPECT_NEAR(AreaOf(corner, triangles), 1.5, 1e-12);
  // A way that leads out and back has no area, a corner that is repeated only a triangle without
  // any.
  const Corners antenna = { { 0, 0, 0 }, { 1, 0, 0 }, { 5, -1, 0 }, { 7, 0, 0 }, { 5, -1, 0 },
    { 1, 0, 0 }, { 1, 1, 0 } };
  triangles = CutEars(antenna, false);
  EXPECT_EQ(triangles.size(), 3u);
  EXPECT_NEAR(AreaOf(antenna, triangles), 0.5, 1e-12);
  const Corners repeated = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  triangles = CutEars(repeated, false);
  EXPECT_EQ(triangles.size(), 9u);
  EXPECT_NEAR(AreaOf(repeated, triangles), 1.0, 1e-12);
  EXPECT_FALSE(ReturnsToPlaces(repeated));
  EXPECT_TRUE(ReturnsToPlaces(two));
}

TEST(PolygonEars, CrossingsAreForcedOnly)
{
  const Corners bow = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  EXPECT_TRUE(CutEars(bow, false).empty());
  EXPECT_EQ(CutEars(bow, true).size(), 6u);
  // Of a polygon that is nothing but crossings no corner gets more than a few triangles.
  std::mt19937 engine(3);
  Corners tangle;
  for (int i = 0; i < 2000; ++i)
  {
    tangle.emplace_back(engine() / 4294967296.0, engine() / 4294967296.0, 0.0);
  }
  const std::vector<Index> triangles = CutEars(tangle, true);
  ASSERT_EQ(triangles.size(), 3u * 1998u);
  std::vector<int> valence(tangle.size(), 0);
  for (const Index corner : triangles)
  {
    ++valence[corner];
  }
  EXPECT_LT(*std::max_element(valence.begin(), valence.end()), 100);
  const Corners line(300, Vector3(1.0, 2.0, 3.0));
  EXPECT_LE(CutEars(line, true).size(), 3u * 298u);
}

TEST(PolygonEars, ManyCornersTakeNearlyLinearTime)
{
  const auto timeOf = [](Index number)
  {
    // A spiral with teeth: most corners are reflex.
    Corners corners;
    for (Index i = 0; i < number / 2; ++i)
    {
      const double t = 4.0 + 60.0 * i / number;
      corners.emplace_back(t * std::cos(t), t * std::sin(t), 0.0);
    }
    for (Index i = number / 2 - 1; i >= 0; --i)
    {
      const double t = 4.0 + 60.0 * i / number;
      const double inner = t - (i % 2 == 0 ? 2.0 : 2.2);
      corners.emplace_back(inner * std::cos(t), inner * std::sin(t), 0.0);
    }
    const std::clock_t begin = std::clock();
    EXPECT_EQ(CutEars(corners, false).size(), 3u * (corners.size() - 2));
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  const double few = std::min(timeOf(10000), timeOf(10000));
  EXPECT_LT(timeOf(80000), 30.0 * few);
}
