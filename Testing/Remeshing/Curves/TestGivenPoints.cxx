// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurveCut.h"
#include "Distance/ClosestPoints.h"
#include "Remesh.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Soundness.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <string>

using namespace DirectionFields;

namespace
{
using Curve = std::vector<Vector3>;

/// The places of the vertices that given points have become, by the points' numbers.
std::map<Index, Vector3> PointsOf(const RemeshResult& mesh)
{
  std::map<Index, Vector3> places;
  for (const MeshChain& chain : mesh.Chains)
  {
    if (chain.Kind == ChainKind::Point)
    {
      EXPECT_EQ(chain.Points.size(), 1U);
      EXPECT_EQ(chain.Name, "Point " + std::to_string(chain.Source));
      places.emplace(chain.Source, mesh.Points[chain.Points[0]]);
    }
  }
  return places;
}

bool IsSaid(const RemeshResult& mesh, const std::string& text)
{
  return std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
    [&](const std::string& note) { return note.find(text) != std::string::npos; });
}
}

// Within, on the boundary, at its corner, on a curve, at a point of the surface, and beside one.
TEST(GivenPoints, BecomeVerticesExactly)
{
  const Surface square = Meshes::Square(30);
  const Curve curve = { { 0.0, 0.41, 0.0 }, { 1.0, 0.57, 0.0 } };
  const Curve points = { { 0.313, 0.777, 0.0 }, { 0.123, 0.0, 0.0 }, { 1.0, 1.0, 0.0 },
    { 0.5, 0.49, 0.0 }, { 0.7, 0.2, 0.0 }, { 0.2001, 0.2001, 0.0 } };
  for (const bool isPure : { false, true })
  {
    RemeshOptions options;
    options.NumberOfFaces = 400;
    options.PureQuads = isPure;
    const RemeshResult mesh =
      Remesh(std::make_shared<Surface>(square), { curve }, points).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.2);
    const std::map<Index, Vector3> found = PointsOf(mesh);
    ASSERT_EQ(found.size(), points.size());
    for (const auto& [number, place] : found)
    {
      EXPECT_LT((place - points[number]).norm(), 1e-15) << number;
    }
  }
}

TEST(GivenPoints, OnARoundBodyAreAtTheClosestPlaces)
{
  const Surface sphere = Meshes::Icosphere(6);
  Curve points;
  for (int k = 0; k < 10; ++k)
  {
    const double z = -0.9 + 0.2 * k;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back(1.003 * Vector3(r * std::cos(2.4 * k), r * std::sin(2.4 * k), z));
  }
  // Decimation is to keep them, too.
  for (const Index faces : { 2000, 500 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    const RemeshResult mesh =
      Remesh(std::make_shared<Surface>(sphere), {}, points).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.2);
    const std::map<Index, Vector3> found = PointsOf(mesh);
    ASSERT_EQ(found.size(), points.size());
    const ClosestPoints closest(sphere);
    for (const auto& [number, place] : found)
    {
      EXPECT_LT((place - closest.Find(points[number]).Position).norm(), 1e-14) << number;
    }
  }
}

// The point of 300 triangles, which lose most of theirs beside it, and points in some of these.
TEST(GivenPoints, BecomeVerticesWhereHundredsOfTrianglesMeet)
{
  Surface fan = { { Vector3::Zero() }, {} };
  constexpr Index sides = 300;
  for (Index k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * Pi * k / sides;
    fan.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    fan.Triangles.push_back({ 0, k + 1, (k + 1) % sides + 1 });
  }
  const Curve points = { { 0.0, 0.0, 0.0 }, { 0.31, 0.4, 0.0 }, { -0.25, 0.55, 0.0 },
    { 0.13, -0.12, 0.0 } };
  for (const Index faces : { 300, 1500 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    const RemeshResult mesh = Remesh(std::make_shared<Surface>(fan), {}, points).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.2);
    const std::map<Index, Vector3> found = PointsOf(mesh);
    ASSERT_EQ(found.size(), points.size());
    for (const auto& [number, place] : found)
    {
      EXPECT_LT((place - points[number]).norm(), 1e-12) << number;
    }
  }
}

TEST(GivenPoints, ThatCannotBeVerticesAreSaid)
{
  const Curve points = { { 0.5, 0.5, 0.0 }, { 0.501, 0.5, 0.0 }, { 0.5, 0.5, 0.4 },
    { 0.25, 0.25, 0.0 }, { 0.25, 0.25, 0.0 } };
  RemeshOptions options;
  options.NumberOfFaces = 400;
  const RemeshResult mesh =
    Remesh(std::make_shared<Surface>(Meshes::Square(30)), {}, points).Compute(options);
  const std::map<Index, Vector3> found = PointsOf(mesh);
  EXPECT_EQ(found.size(), 2U);
  EXPECT_EQ(found.count(0), 1U);
  EXPECT_EQ(found.count(3), 1U);
  EXPECT_TRUE(IsSaid(mesh, "Point 2 is no vertex of the mesh: farther from the surface"));
  EXPECT_TRUE(IsSaid(mesh, "Point 1 is no vertex of the mesh: closer than a tenth of an edge"));
  EXPECT_TRUE(
    IsSaid(mesh, "Point 4 is no vertex of the mesh, since others before in the list stand"));
}

// The number of each curve stays with its edges, also where one goes on from the other.
TEST(GivenPoints, CurvesAreFoundOnTheMesh)
{
  const std::vector<Curve> curves = { { { 0.1, 0.3, 0.0 }, { 0.5, 0.3, 0.0 } },
    { { 0.5, 0.3, 0.0 }, { 0.9, 0.3, 0.0 } }, { { 0.2, 0.0, 0.0 }, { 0.2, 1.0, 0.0 } } };
  RemeshOptions options;
  options.NumberOfFaces = 400;
  const RemeshResult mesh =
    Remesh(std::make_shared<Surface>(Meshes::Square(20)), curves).Compute(options);
  std::map<Index, double> length;
  for (const MeshChain& chain : mesh.Chains)
  {
    for (std::size_t i = 1; chain.Kind == ChainKind::Curve && i < chain.Points.size(); ++i)
    {
      length[chain.Source] +=
        (mesh.Points[chain.Points[i]] - mesh.Points[chain.Points[i - 1]]).norm();
      EXPECT_EQ(chain.Name.rfind("Curve " + std::to_string(chain.Source) + " ", 0), 0U);
    }
  }
  ASSERT_EQ(length.size(), 3U);
  EXPECT_NEAR(length[0] + length[1], 0.8, 1e-9);
  EXPECT_NEAR(length[0], 0.4, 0.5 * mesh.EdgeLength);
  EXPECT_NEAR(length[2], 1.0, 1e-9);
}

// Parts are Delaunay, so that they are no slivers: the time per point grows by less than the
// logarithm of their number.
TEST(GivenPoints, ManyScatteredInOneTriangleAreCutIntoItInTimeByTheirNumber)
{
  const Surface triangle = { { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
    { { 0, 1, 2 } } };
  // Fractions of the golden ratio and of another one, of which none comes twice.
  const auto scattered = [](int count)
  {
    Curve points;
    for (int k = 0; k < count; ++k)
    {
      const double x = std::fmod(0.6180339887 * k, 1.0);
      const double y = std::fmod(0.7548776662 * k, 1.0);
      points.emplace_back(0.02 + 0.4 * x, 0.02 + 0.4 * y, 0.0);
    }
    return points;
  };
  const auto partsOf = [&](int count)
  {
    const Curve points = scattered(count);
    const auto start = std::clock();
    const CurveCut cut = CutAlong(triangle, { {}, points });
    const double time = static_cast<double>(std::clock() - start);
    EXPECT_EQ(std::count(cut.Points.begin(), cut.Points.end(), None), 0);
    std::map<Index, Index> valence;
    double area = 0.0;
    for (const Triangle& t : cut.Cut.Triangles)
    {
      const Vector3& a = cut.Cut.Points[t[0]];
      const double twice = (cut.Cut.Points[t[1]] - a).cross(cut.Cut.Points[t[2]] - a).z();
      EXPECT_GT(twice, 0.0);
      area += 0.5 * twice;
      for (const Index p : t)
      {
        ++valence[p];
      }
    }
    EXPECT_NEAR(area, 0.5, 1e-12);
    for (const auto& [point, triangles] : valence)
    {
      EXPECT_LT(triangles, point < 3 ? 100 : 30) << point;
    }
    return time;
  };
  const double few = partsOf(4000);
  EXPECT_LT(partsOf(32000), 24.0 * few);
}

// Of which each is searched for from the last one on.
TEST(GivenPoints, ManyInOneTriangleAreCutIntoIt)
{
  const Surface triangle = { { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
    { { 0, 1, 2 } } };
  Curve curve;
  for (int k = 0; k <= 3000; ++k)
  {
    const double angle = 2.0 * Pi * k / 3000;
    curve.push_back({ 0.3 + 0.2 * std::cos(angle), 0.3 + 0.2 * std::sin(angle), 0.0 });
  }
  const CurveCut cut = CutAlong(triangle, { { curve }, {} });
  EXPECT_TRUE(cut.Notes.empty());
  double area = 0.0;
  for (const Triangle& t : cut.Cut.Triangles)
  {
    const Vector3& a = cut.Cut.Points[t[0]];
    area += 0.5 * (cut.Cut.Points[t[1]] - a).cross(cut.Cut.Points[t[2]] - a).z();
  }
  EXPECT_NEAR(area, 0.5, 1e-12);
  double length = 0.0;
  for (const std::array<Index, 2>& edge : cut.Edges)
  {
    length += (cut.Cut.Points[edge[1]] - cut.Cut.Points[edge[0]]).norm();
  }
  // No zigzag, and only few more triangles than points need, of which none is a sliver that leads
  // far away.
  EXPECT_NEAR(length, 0.4 * Pi, 0.01 * 0.4 * Pi);
  EXPECT_LT(cut.Cut.Triangles.size(), 24000U);
  int slivers = 0;
  for (const Triangle& t : cut.Cut.Triangles)
  {
    double longest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const Vector3 edge = cut.Cut.Points[t[(c + 1) % 3]] - cut.Cut.Points[t[c]];
      longest = std::max(longest, edge.squaredNorm());
    }
    const Vector3& a = cut.Cut.Points[t[0]];
    const double twice = (cut.Cut.Points[t[1]] - a).cross(cut.Cut.Points[t[2]] - a).z();
    slivers += longest > 0.05 * 0.05 && twice < 0.1 * longest ? 1 : 0;
  }
  EXPECT_LT(slivers, 5);
  // Points at the same place are one, and change nothing.
  Curve twice;
  for (const Vector3& point : curve)
  {
    twice.insert(twice.end(), 2, point);
  }
  EXPECT_EQ(CutAlong(triangle, { { twice }, {} }).Cut.Triangles, cut.Cut.Triangles);
  int asked = 0;
  Remesh mesher(std::make_shared<Surface>(triangle), { curve });
  const RemeshResult stopped = mesher.Compute({}, {},
    [&](double done)
    {
      EXPECT_EQ(done, 0.0);
      ++asked;
      return false;
    });
  EXPECT_TRUE(stopped.Aborted);
  EXPECT_EQ(asked, 1);
}
