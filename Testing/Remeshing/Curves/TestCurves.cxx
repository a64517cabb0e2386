// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurveCut.h"
#include "MeshError.h"
#include "Remesh.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Soundness.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

using namespace DirectionFields;

namespace
{
using Curve = std::vector<Vector3>;

Curve Circle(const Vector3& center, double radius, int points)
{
  Curve curve;
  for (int k = 0; k <= points; ++k)
  {
    const double angle = 2.0 * Pi * (k % points) / points;
    curve.push_back(center + radius * Vector3(std::cos(angle), std::sin(angle), 0.0));
  }
  return curve;
}

double AreaOf(const Surface& surface)
{
  double area = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3& a = surface.Points[t[0]];
    area += 0.5 * (surface.Points[t[1]] - a).cross(surface.Points[t[2]] - a).norm();
  }
  return area;
}

double LengthOf(const CurveCut& cut)
{
  double length = 0.0;
  for (const std::array<Index, 2>& edge : cut.Edges)
  {
    length += (cut.Cut.Points[edge[1]] - cut.Cut.Points[edge[0]]).norm();
  }
  return length;
}

/// Each point on an edge of the features of a mesh, at most this far from them.
double FarthestFromFeatures(const RemeshResult& mesh, const Curve& samples)
{
  double farthest = 0.0;
  for (const Vector3& sample : samples)
  {
    double least = 1e300;
    for (const MeshChain& chain : mesh.Chains)
    {
      for (std::size_t i = 1; i < chain.Points.size() && chain.Kind != ChainKind::Boundary; ++i)
      {
        const Vector3& a = mesh.Points[chain.Points[i - 1]];
        const Vector3 edge = mesh.Points[chain.Points[i]] - a;
        const double s = std::clamp(edge.dot(sample - a) / edge.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + s * edge - sample).norm());
      }
    }
    farthest = std::max(farthest, least);
  }
  return farthest;
}

RemeshResult Remeshed(
  const Surface& surface, const std::vector<Curve>& curves, Index faces, RemeshOptions options = {})
{
  options.NumberOfFaces = faces;
  return Remesh(std::make_shared<Surface>(surface), curves).Compute(options);
}
}

TEST(Curves, CutsKeepTheSurface)
{
  const Surface square = Meshes::Jittered(Meshes::Square(10), 0.0, 1);
  const CurveCut cut = CutAlong(square, { { { { 0.0, 0.13, 0.0 }, { 1.0, 0.71, 0.0 } } }, {} });
  EXPECT_TRUE(cut.Notes.empty());
  EXPECT_NEAR(AreaOf(cut.Cut), 1.0, 1e-12);
  // A straight curve has no more length for its cuts, but for points that it takes.
  EXPECT_NEAR(LengthOf(cut), std::hypot(1.0, 0.58), 2e-3);
  for (std::size_t p = 0; p < square.Points.size(); ++p)
  {
    EXPECT_EQ(cut.Cut.Points[p], square.Points[p]);
  }
  std::vector<double> parts(square.Triangles.size(), 0.0);
  for (std::size_t t = 0; t < cut.Cut.Triangles.size(); ++t)
  {
    const Triangle& c = cut.Cut.Triangles[t];
    const Vector3 area = 0.5 *
      (cut.Cut.Points[c[1]] - cut.Cut.Points[c[0]])
        .cross(cut.Cut.Points[c[2]] - cut.Cut.Points[c[0]]);
    EXPECT_GT(area.z(), 0.0);
    parts[cut.Parents[t]] += area.z();
  }
  for (const double part : parts)
  {
    EXPECT_NEAR(part, 0.005, 1e-12);
  }
  // Each interior edge has two triangles, also along the cut.
  std::map<std::array<Index, 2>, int> triangles;
  for (const Triangle& t : cut.Cut.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const auto ends = std::minmax(t[c], t[(c + 1) % 3]);
      ++triangles[{ ends.first, ends.second }];
    }
  }
  for (const auto& [ends, count] : triangles)
  {
    const Vector3 middle = 0.5 * (cut.Cut.Points[ends[0]] + cut.Cut.Points[ends[1]]);
    const bool isBoundary =
      std::min({ middle.x(), middle.y(), 1.0 - middle.x(), 1.0 - middle.y() }) < 1e-12;
    EXPECT_EQ(count, isBoundary ? 1 : 2);
  }
}

/// Lines across squares that are halved one way or the other: they pass points of the surface at any
/// distance, in any order.
TEST(Curves, StraightOnesStayStraight)
{
  constexpr int squares = 30;
  for (const bool isMirrored : { false, true })
  {
    Surface plane = Meshes::Square(squares);
    for (Vector3& p : plane.Points)
    {
      p.x() = isMirrored ? 1.0 - p.x() : p.x();
    }
    for (Triangle& t : plane.Triangles)
    {
      std::swap(t[1], t[isMirrored ? 2 : 1]);
    }
    for (int k = 0; k < 60; ++k)
    {
      const Vector3 from(0.2, 0.2, 0.0);
      const Vector3 to(0.8, 0.2 + k / 100.0, 0.0);
      const CurveCut cut = CutAlong(plane, { { { from, to } }, {} });
      const Vector3 along = (to - from).normalized();
      for (const std::array<Index, 2>& edge : cut.Edges)
      {
        const Vector3& a = cut.Cut.Points[edge[0]];
        const Vector3& b = cut.Cut.Points[edge[1]];
        EXPECT_LT((a - from).cross(along).norm() * squares, 0.05 * std::sqrt(2.0)) << k;
        EXPECT_GT(std::abs((b - a).normalized().dot(along)), std::cos(10.0 * Pi / 180.0)) << k;
      }
    }
    // One line of the mesh, whose ends are 40 degrees off the sides.
    const RemeshResult mesh =
      Remeshed(plane, { { { 0.2, 0.2, 0.0 }, { 0.8, 0.75, 0.0 } } }, 2000, {});
    EXPECT_EQ(std::count_if(mesh.Chains.begin(), mesh.Chains.end(),
                [](const MeshChain& chain) { return chain.Kind == ChainKind::Curve; }),
      1);
  }
}

TEST(Curves, OnesAtAnyAngleTurnNoFaceOver)
{
  for (const double degrees : { 20.0, 34.0, 38.0, 42.0 })
  {
    const double angle = degrees * Pi / 180.0;
    const Vector3 half = 0.3 * Vector3(std::cos(angle), std::sin(angle), 0.0);
    const Vector3 middle(0.5, 0.5, 0.0);
    for (const Index faces : { 2000, 4000 })
    {
      const RemeshResult mesh =
        Remeshed(Meshes::Square(30), { { middle - half, middle + half } }, faces);
      EXPECT_EQ(mesh.TurnedFaces, 0) << degrees << ' ' << faces;
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.2) << degrees << ' ' << faces;
    }
  }
}

TEST(Curves, OneFromSideToSideAtHalfARightAngleTurnsNoFaceOver)
{
  for (const double begin : { 0.25, 0.35 })
  {
    for (const Index faces : { 2000, 4000 })
    {
      const RemeshResult mesh = Remeshed(Meshes::Square(30),
        { { Vector3(0.0, begin, 0.0), Vector3(1.0 - begin, 1.0, 0.0) } }, faces);
      EXPECT_EQ(mesh.TurnedFaces, 0) << begin << ' ' << faces;
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.2) << begin << ' ' << faces;
    }
  }
}

TEST(Curves, CurvesThatCrossMeetInAPoint)
{
  const CurveCut cut = CutAlong(Meshes::Square(9),
    { { { { 0.1, 0.17, 0.0 }, { 0.9, 0.83, 0.0 } }, { { 0.1, 0.83, 0.0 }, { 0.9, 0.17, 0.0 } } },
      {} });
  std::map<Index, int> valence;
  for (const std::array<Index, 2>& edge : cut.Edges)
  {
    ++valence[edge[0]];
    ++valence[edge[1]];
  }
  int ends = 0;
  int crossings = 0;
  for (const auto& entry : valence)
  {
    ends += entry.second == 1 ? 1 : 0;
    crossings += entry.second == 4 ? 1 : 0;
  }
  EXPECT_EQ(ends, 4);
  EXPECT_EQ(crossings, 1);
}

TEST(Curves, EdgesOfTheSurfaceAreTakenAsTheyAre)
{
  const Surface square = Meshes::Square(8);
  const CurveCut cut = CutAlong(square, { { { { 0.5, 0.0, 0.0 }, { 0.5, 1.0, 0.0 } } }, {} });
  EXPECT_EQ(cut.Cut.Points.size(), square.Points.size());
  EXPECT_EQ(cut.Cut.Triangles, square.Triangles);
  EXPECT_EQ(cut.Edges.size(), 8U);
}

TEST(Curves, PartsThatAreNotOnTheSurfaceAreLeftOutAndSaid)
{
  const Curve away = { { 0.2, 0.5, 0.0 }, { 0.4, 0.5, 0.0 }, { 0.6, 0.5, 0.3 }, { 0.8, 0.5, 0.0 } };
  const CurveCut cut = CutAlong(Meshes::Square(10), { { away }, {} });
  ASSERT_EQ(cut.Notes.size(), 1U);
  EXPECT_NE(cut.Notes[0].find("Parts of curve 0 are"), std::string::npos);
  EXPECT_NEAR(LengthOf(cut), 0.2, 1e-9);
}

// Across the plane of an oblique line, a circle, and a line that ends within.
TEST(Curves, BecomeLinesOfTheMesh)
{
  const Surface square = Meshes::Square(30);
  const Curve circle = Circle({ 0.5, 0.5, 0.0 }, 0.3, 60);
  const RemeshResult mesh = Remeshed(square, { circle }, 900);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.2);
  EXPECT_LT(FarthestFromFeatures(mesh, circle), 0.1 * mesh.EdgeLength);
  for (const MeshChain& chain : mesh.Chains)
  {
    for (std::size_t i = 0; chain.Kind == ChainKind::Curve && i < chain.Points.size(); ++i)
    {
      EXPECT_NEAR((mesh.Points[chain.Points[i]] - Vector3(0.5, 0.5, 0.0)).norm(), 0.3,
        0.08 * mesh.EdgeLength);
    }
  }
  EXPECT_TRUE(mesh.Notes.empty()) << mesh.Notes[0];
  const RemeshResult without = Remeshed(square, {}, 900);
  EXPECT_GT(FarthestFromFeatures(without, circle), 1.0);
}

TEST(Curves, LinesAroundARoundBodyAreKept)
{
  const Surface sphere = Meshes::Icosphere(4);
  Curve wave;
  for (int k = 0; k <= 120; ++k)
  {
    const double angle = 2.0 * Pi * (k % 120) / 120;
    wave.push_back(
      Vector3(std::cos(angle), std::sin(angle), 0.25 * std::cos(3.0 * angle)).normalized());
  }
  RemeshOptions options;
  for (const bool isPure : { false, true })
  {
    options.PureQuads = isPure;
    const RemeshResult mesh = Remeshed(sphere, { wave }, 1500, options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.2);
    EXPECT_LT(FarthestFromFeatures(mesh, wave), 0.1 * mesh.EdgeLength);
    EXPECT_TRUE(mesh.Notes.empty()) << mesh.Notes[0];
  }
}

// Sources, regions, sizes and directions are those of the surface that came in.
TEST(Curves, EverythingRefersToTheSurfaceGiven)
{
  const Surface square = Meshes::Square(12);
  RemeshOptions options;
  std::vector<Vector3> directions;
  for (const Vector3& p : square.Points)
  {
    options.Sizing.push_back(1.0 + p.x());
    directions.emplace_back(1.0, 0.0, 0.0);
  }
  for (const Triangle& t : square.Triangles)
  {
    options.Regions.push_back(
      (square.Points[t[0]] + square.Points[t[1]] + square.Points[t[2]]).y() > 1.5 ? 1 : 0);
  }
  options.NumberOfFaces = 300;
  const Curve line = { { 0.31, 0.0, 0.0 }, { 0.31, 1.0, 0.0 } };
  const RemeshResult mesh =
    Remesh(std::make_shared<Surface>(square), { line }).Compute(options, directions);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    const Triangle& t = square.Triangles[mesh.SourceTriangle[v]];
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      place += mesh.SourceWeights[v][c] * square.Points[t[c]];
    }
    EXPECT_LT((place - mesh.Points[v]).norm(), 1e-9);
  }
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    EXPECT_EQ(mesh.Regions[f], options.Regions[mesh.FaceSource[f]]);
  }
  EXPECT_LT(
    FarthestFromFeatures(mesh, { { 0.31, 0.2, 0.0 }, { 0.31, 0.7, 0.0 } }), 0.1 * mesh.EdgeLength);
}

// Sides of a cut that have points of their own.
TEST(Curves, SeamsAreCrossed)
{
  const Surface soup = Meshes::Soup(Meshes::Square(6));
  const Curve line = { { 0.0, 0.4, 0.0 }, { 1.0, 0.63, 0.0 } };
  const CurveCut cut = CutAlong(soup, { { line }, {} });
  EXPECT_TRUE(cut.Notes.empty());
  EXPECT_NEAR(LengthOf(cut), std::hypot(1.0, 0.23), 1e-3);
  EXPECT_LT(FarthestFromFeatures(Remeshed(soup, { line }, 200), line), 1e-2);
}

// They are at the same place as others, but there is nothing to split.
TEST(Curves, TrianglesWithACornerTwiceAreNotCut)
{
  const Surface given = { { { 0.1, 0.2, 0.0 }, { 0.7, 0.5, 0.0 }, { 0.2, 0.9, 0.0 } },
    { { 0, 0, 1 }, { 0, 1, 2 }, { 1, 0, 1 } } };
  const Vector3 along = given.Points[1] - given.Points[0];
  const Vector3 outward(along.y(), -along.x(), 0.0);
  for (double part = 0.2; part < 0.8; part += 0.013)
  {
    const Vector3 start = given.Points[0] + part * along;
    const Vector3 end(0.3, 0.55, 0.0);
    const CurveCut cut = CutAlong(given, { { { start + 0.005 * outward, end } }, {} });
    EXPECT_TRUE(cut.Notes.empty());
    EXPECT_NEAR(AreaOf(cut.Cut), AreaOf(given), 1e-15);
    // But for an edge that the end may be taken to.
    EXPECT_NEAR(LengthOf(cut), (end - start).norm(), 1e-3);
    ASSERT_EQ(cut.Cut.Triangles.size(), 6U);
    for (std::size_t t = 0; t < cut.Cut.Triangles.size(); ++t)
    {
      EXPECT_EQ(cut.Parents[t], t == 0 ? 0 : t == 2 ? 2 : 1) << t;
    }
    EXPECT_EQ(cut.Cut.Triangles[0], given.Triangles[0]);
    EXPECT_EQ(cut.Cut.Triangles[2], given.Triangles[2]);
  }
}

TEST(Curves, CoordinatesThatAreTooLargeAreRefused)
{
  const auto large = std::make_shared<Surface>(
    Surface{ { { 0.0, 0.0, 0.0 }, { 1e308, 0.0, 0.0 }, { 0.0, 1e308, 0.0 } }, { { 0, 1, 2 } } });
  const Curve line = { { 3e307, 3e307, 0.0 }, { 1e307, 1e307, 0.0 } };
  EXPECT_THROW(Remesh(large, { line }).Compute({}), MeshError);
  const auto square = std::make_shared<Surface>(Meshes::Square(4));
  for (const double bad : { std::nan(""), HUGE_VAL })
  {
    try
    {
      Remesh(square, { { { 0.2, 0.2, 0.0 } }, { { 0.2, 0.2, 0.0 }, { 0.5, bad, 0.0 } } });
      ADD_FAILURE();
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(std::string(error.what()),
        "Point 1 of curve 1 has a coordinate that is NaN or infinite. Remove it.");
    }
  }
}
