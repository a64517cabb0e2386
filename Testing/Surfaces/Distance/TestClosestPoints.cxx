// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoints.h"
#include "FaceMesh/Faces.h"
#include "Features/KeptFeatures.h"
#include "Improvement/FaceSmoothing.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace DirectionFields;

namespace
{
constexpr double Anywhere = std::numeric_limits<double>::infinity();

std::vector<ClosestPoints::Corners> TrianglesOf(const Surface& surface)
{
  std::vector<ClosestPoints::Corners> triangles;
  for (const Triangle& t : surface.Triangles)
  {
    triangles.push_back({ surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] });
  }
  return triangles;
}

Vector3 RandomPlace(std::mt19937& engine)
{
  Vector3 place;
  for (int c = 0; c < 3; ++c)
  {
    place[c] = 4.0 * (engine() / 4294967296.0) - 2.0;
  }
  return place;
}

/// A cone whose tip is joined to all points of the rim.
Surface Needles(int count)
{
  Surface cone;
  cone.Points.emplace_back(0.0, 0.0, 1.0);
  for (int k = 0; k < count; ++k)
  {
    const double angle = 2.0 * Pi * k / count;
    cone.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    cone.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % count });
  }
  return cone;
}

void ExpectWhatComparisonFinds(const std::vector<ClosestPoints::Corners>& triangles)
{
  std::mt19937 engine(1);
  const ClosestPoints tree(triangles);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 place = RandomPlace(engine);
    double least = Anywhere;
    for (const ClosestPoints::Corners& t : triangles)
    {
      least = std::min(least,
        ClosestPoints(std::vector<ClosestPoints::Corners>{ t })
          .Find(place, Vector3::Zero(), Anywhere)
          .SquaredDistance);
    }
    const ClosestPoints::Answer answer = tree.Find(place, Vector3::Zero(), Anywhere);
    EXPECT_NEAR(answer.SquaredDistance, least, 1e-14);
    const ClosestPoints::Corners& t = triangles[answer.Triangle];
    const Vector3 weighted =
      answer.Weights[0] * t[0] + answer.Weights[1] * t[1] + answer.Weights[2] * t[2];
    EXPECT_LT((weighted - answer.Position).norm(), 1e-12);
    EXPECT_NEAR((answer.Position - place).squaredNorm(), least, 1e-12);
  }
}
}

TEST(ClosestPoints, TreeFindsWhatComparisonWithAllFinds)
{
  ExpectWhatComparisonFinds(TrianglesOf(Meshes::Torus(17, 9)));
  ExpectWhatComparisonFinds(TrianglesOf(Needles(300)));
}

TEST(ClosestPoints, NeedlesAreFoundWithoutLookingAtAll)
{
  // The boxes of thousands of needles are around each of the places.
  constexpr int count = 40000;
  const Surface cone = Needles(count);
  const ClosestPoints tree(cone);
  for (int k = 0; k < count; ++k)
  {
    for (const double height : { 0.1, 0.3, 0.5, 0.6 })
    {
      const Vector3 place = height * cone.Points[0] +
        0.5 * (1.0 - height) * (cone.Points[1 + k] + cone.Points[1 + (k + 1) % count]);
      ASSERT_EQ(tree.Find(place).Triangle, k);
    }
  }
}

TEST(ClosestPoints, NeedlesThatFaceTheOtherWayAreNotLookedAt)
{
  // Searches for the other side of a fan would look at all of its triangles.
  constexpr int count = 40000;
  const Surface cone = Needles(count);
  const ClosestPoints tree(cone);
  for (int k = 0; k < count; ++k)
  {
    const Vector3 place = 0.5 * (cone.Points[0] + cone.Points[1 + k]);
    ASSERT_EQ(tree.Find(place, Vector3(0.0, 0.0, -1.0)).Triangle, None);
  }
  // And so would they on a plane, as many as a hundred million of them.
  const Surface square = Meshes::Square(100);
  const ClosestPoints plane(square);
  for (int k = 0; k < 20000; ++k)
  {
    const Vector3& place = square.Points[k % square.Points.size()];
    ASSERT_EQ(plane.Find(place, Vector3(0.1, 0.0, -1.0)).Triangle, None);
  }
  // Where one half of them faces the right way it is found whatever the order is.
  const std::vector<ClosestPoints::Corners> few = TrianglesOf(Needles(300));
  const ClosestPoints tip(few);
  std::mt19937 engine(2);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 place = RandomPlace(engine);
    const Vector3 normal = RandomPlace(engine) - Vector3(0.0, 0.0, 1.0);
    double least = Anywhere;
    for (const ClosestPoints::Corners& t : few)
    {
      const ClosestPoints::Answer answer =
        ClosestPoints(std::vector<ClosestPoints::Corners>{ t }).Find(place, normal);
      least = answer.Triangle == None ? least : std::min(least, answer.SquaredDistance);
    }
    const ClosestPoints::Answer answer = tip.Find(place, normal);
    EXPECT_EQ(answer.Triangle == None, least == Anywhere);
    if (answer.Triangle != None)
    {
      EXPECT_NEAR(answer.SquaredDistance, least, 1e-14);
    }
  }
}

TEST(ClosestPoints, OfManyTrianglesAtOnePlaceTheFirstIsFound)
{
  // Nothing tells them apart where the tree is cut into halves.
  std::vector<ClosestPoints::Corners> triangles = TrianglesOf(Meshes::Square(1));
  triangles.resize(1);
  triangles.insert(triangles.end(), 1000, triangles.front());
  const ClosestPoints tree(triangles);
  EXPECT_EQ(tree.Find(Vector3(0.6, 0.3, 1.0)).Triangle, 0);
  EXPECT_EQ(tree.Find(Vector3(0.6, 0.3, 1.0), Vector3::Zero(), Anywhere, 700).Triangle, 0);
}

TEST(ClosestPoints, SideAndDistanceAreKeptTo)
{
  const ClosestPoints tree(TrianglesOf(Meshes::Icosphere(3)));
  // From the middle of the sphere's inside, triangles that face downwards are below.
  const ClosestPoints::Answer below =
    tree.Find(Vector3(0.0, 0.0, 0.5), Vector3(0.0, 0.0, -1.0), Anywhere);
  EXPECT_LT(below.Position[2], 0.16);
  EXPECT_EQ(tree.Find(Vector3(0.0, 0.0, 3.0), Vector3::Zero(), 1.0).Triangle, None);
  EXPECT_NE(tree.Find(Vector3(0.0, 0.0, 3.0), Vector3::Zero(), 2.5).Triangle, None);
}

TEST(ClosestPoints, AnyTwoCornersMayBeAtOnePlace)
{
  const Vector3 a(0.25, 0.25, 0.25);
  const Vector3 b(-0.25, -0.25, 0.25);
  for (const ClosestPoints::Corners& corners :
    { ClosestPoints::Corners{ a, a, b }, ClosestPoints::Corners{ a, b, a },
      ClosestPoints::Corners{ b, a, a }, ClosestPoints::Corners{ a, a, a } })
  {
    const ClosestPoints places(std::vector<ClosestPoints::Corners>{ corners });
    for (const double t : { -0.5, 0.0, 0.25, 1.0, 1.5 })
    {
      const Vector3 place = a + t * (b - a) + Vector3(0.0, 0.0, 0.5);
      const ClosestPoints::Answer at = places.Find(place);
      ASSERT_EQ(at.Triangle, 0);
      const bool isPoint = corners[0] == corners[1] && corners[1] == corners[2];
      const Vector3 expected = isPoint ? a : Vector3(a + std::clamp(t, 0.0, 1.0) * (b - a));
      EXPECT_LT((at.Position - expected).norm(), 1e-15) << t;
    }
  }
}

TEST(ClosestPoints, SegmentsAreTrianglesWithoutArea)
{
  const Vector3 p(0.0, 0.0, 0.0);
  const Vector3 q(2.0, 0.0, 0.0);
  const ClosestPoints segment(std::vector<ClosestPoints::Corners>{ { p, q, q } });
  EXPECT_LT((segment.Find(Vector3(0.7, 1.0, 0.0), Vector3::Zero(), Anywhere).Position -
              Vector3(0.7, 0.0, 0.0))
              .norm(),
    1e-14);
  EXPECT_EQ(segment.Find(Vector3(5.0, 1.0, 0.0), Vector3::Zero(), Anywhere).Position, q);
  EXPECT_EQ(segment.Find(Vector3(-5.0, 1.0, 0.0), Vector3::Zero(), Anywhere).Position, p);
}

TEST(ScaledJacobian, IsTheSineOfTheWorstAngle)
{
  const std::vector<Vector3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0.5, std::sqrt(0.75), 0 }, { 1.5, 1, 0 }, { 0.5, 1, 0 } };
  EXPECT_DOUBLE_EQ(ScaledJacobian(points, { 0, 1, 2, 3 }), 1.0);
  EXPECT_NEAR(ScaledJacobian(points, { 0, 1, 4, None }), 1.0, 1e-12);
  // A parallelogram that leans by half of its height.
  EXPECT_NEAR(ScaledJacobian(points, { 0, 1, 5, 6 }), 1.0 / std::sqrt(1.25), 1e-12);
  // Its sides cross.
  EXPECT_LT(ScaledJacobian(points, { 0, 2, 1, 3 }), 0.1);
}

TEST(FaceSmoothing, BringsAGridBackThatWasPulledApart)
{
  constexpr int cells = 6;
  const Surface square = Meshes::Square(cells);
  Faces faces;
  std::vector<Vector3> points;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      points.emplace_back(i / 6.0, j / 6.0, 0.0);
    }
  }
  SmoothingDomain domain{ ClosestPoints(TrianglesOf(square)), {}, {}, {} };
  const std::vector<Vector3> regular = points;
  std::mt19937 engine(5);
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const bool isFixed = i == 0 || j == 0 || i == cells || j == cells;
      domain.Line.push_back(isFixed ? -1 : 0);
      domain.EdgeLength.push_back(1.0 / cells);
      if (!isFixed)
      {
        points[j * (cells + 1) + i] += 0.02 * RandomPlace(engine).cwiseProduct(Vector3(1, 1, 0));
      }
      if (i < cells && j < cells)
      {
        const Index v = j * (cells + 1) + i;
        faces.Corners.push_back({ v, v + 1, v + cells + 2, v + cells + 1 });
        faces.IsRegular.push_back(1);
      }
    }
  }
  const VertexStars stars(faces, static_cast<Index>(points.size()));
  MovableFaces movable(stars, domain, points);
  RelaxFaces(movable, 60);
  ImproveFaces(movable);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    EXPECT_LT((points[v] - regular[v]).norm(), 1e-3);
  }
}

TEST(KeptFeatures, OfACubeAreItsEdges)
{
  const SurfaceGeometry geometry(Meshes::FlatlySubdivided(Meshes::Cube(), 2));
  const auto count = [&](const FeatureSettings& settings)
  {
    const std::vector<char> isFeature = FindFeatures(geometry, settings);
    return std::count(isFeature.begin(), isFeature.end(), 1);
  };
  // Each edge is one of four. They end at the corners, nowhere freely: however long the shortest is
  // to be.
  EXPECT_EQ(count({ true, 40.0, 0.5, 0.0 }), 48);
  EXPECT_EQ(count({ true, 40.0, 0.5, 100.0 }), 48);
  EXPECT_EQ(count({ true, 100.0, 0.5, 0.0 }), 0);
  EXPECT_EQ(count({ false, 40.0, 0.5, 0.0 }), 0);
}

TEST(KeptFeatures, ClosedOnesAreKeptFromTheShortestLengthOn)
{
  // The rim between two disks at an angle is 2 pi long, about.
  Surface lens = Meshes::Disk(8);
  const Index points = static_cast<Index>(lens.Points.size());
  for (Vector3& p : lens.Points)
  {
    p[2] = 0.8 * (1.0 - p.squaredNorm());
  }
  Surface lower = lens;
  for (Vector3& p : lower.Points)
  {
    p[2] = -p[2];
  }
  for (Triangle& t : lower.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  const Surface both = Meshes::Joined(lens, lower);
  // The points on the rim are those of the upper one.
  Surface closed = both;
  for (Triangle& t : closed.Triangles)
  {
    for (Index& p : t)
    {
      p = p >= points && std::abs(closed.Points[p][2]) < 1e-12 ? p - points : p;
    }
  }
  const SurfaceGeometry geometry(closed);
  const auto any = [&](double shortest)
  {
    const std::vector<char> isFeature = FindFeatures(geometry, { true, 60.0, 0.0, shortest });
    return std::count(isFeature.begin(), isFeature.end(), 1) > 0;
  };
  EXPECT_TRUE(any(6.0));
  EXPECT_FALSE(any(6.5));
}
