// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/PreparedSurface.h"

#include "Meshes/Surfaces.h"
#include "Preparation/PreparedField.h"
#include "Preparation/SizeAdvice.h"
#include "Preparation/WantedSizes.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr FeatureSettings Sharp{ true, 40.0, 0.5, 0.0 };

double AreaOf(const Surface& surface)
{
  double area = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    area += 0.5 *
      (surface.Points[t[1]] - surface.Points[t[0]])
        .cross(surface.Points[t[2]] - surface.Points[t[0]])
        .norm();
  }
  return area;
}

Index EulerCharacteristicOf(const TriangleMesh& mesh)
{
  return mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles();
}
}

TEST(PreparedSurface, OneSidedSurfacesAreCutOpen)
{
  // A strip or bottle that is cut open has two sides: no triangle is covered twice.
  for (const Surface& surface : { Meshes::MoebiusStrip(30, 3), Meshes::KleinBottle(16, 10) })
  {
    const PreparedSurface prepared(surface, 4, Sharp);
    const TriangleMesh& mesh = prepared.GetGeometry().Mesh;
    EXPECT_EQ(static_cast<std::size_t>(mesh.GetNumberOfTriangles()), surface.Triangles.size());
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      EXPECT_EQ(mesh.Mirror(3 * t), None);
    }
    EXPECT_GT(prepared.GetSurface()->Points.size(), surface.Points.size());
    // Copies are at the places of their originals.
    const std::vector<Index> originals = prepared.GetOriginals();
    for (std::size_t p = 0; p < originals.size(); ++p)
    {
      EXPECT_EQ(prepared.GetSurface()->Points[p], surface.Points[originals[p]]);
    }
    EXPECT_NEAR(AreaOf(*prepared.GetSurface()), AreaOf(surface), 1e-12);
  }
}

TEST(PreparedSurface, NoTwoNeighboursHaveNoFrame)
{
  // All vertices of a cube of twelve triangles are corners.
  for (const Surface& surface : { Meshes::Cube(), Meshes::Tetrahedron(), Meshes::Octahedron() })
  {
    for (const int degree : { 4, 6 })
    {
      const PreparedSurface prepared(surface, degree, Sharp);
      const SurfaceGeometry& geometry = prepared.GetGeometry();
      const std::vector<char> isFrameless =
        FramelessVertices(geometry, degree, prepared.FindFeatures(Sharp));
      EXPECT_GT(std::count(isFrameless.begin(), isFrameless.end(), 1), 0);
      for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
      {
        const Index h = geometry.Mesh.HalfEdge(e);
        EXPECT_FALSE(
          isFrameless[geometry.Mesh.Tail(h)] != 0 && isFrameless[geometry.Mesh.Head(h)] != 0);
      }
      EXPECT_EQ(EulerCharacteristicOf(geometry.Mesh), 2);
      EXPECT_NEAR(AreaOf(*prepared.GetSurface()), AreaOf(surface), 1e-12);
    }
  }
}

TEST(PreparedSurface, WeightsReferToTheCornersOfTheInput)
{
  const Surface surface = Meshes::Scrambled(Meshes::Icosphere(1), 5);
  const PreparedSurface prepared(surface, 4, Sharp);
  const std::vector<ClosestPoints::Corners> triangles = prepared.GetTriangles();
  const std::array<double, 3> weights = { 0.2, 0.3, 0.5 };
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto triangle = static_cast<Index>(t);
    const Vector3 place =
      weights[0] * triangles[t][0] + weights[1] * triangles[t][1] + weights[2] * triangles[t][2];
    const Triangle& input = surface.Triangles[prepared.InputTriangle(triangle)];
    const std::array<double, 3> own = prepared.InputWeights(triangle, weights);
    Vector3 again = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      again += own[c] * surface.Points[input[c]];
    }
    EXPECT_LT((again - place).norm(), 1e-12);
  }
}

TEST(PreparedSurface, PathsAlongFeaturesAreThoseOfTheInput)
{
  // The edges of a cube, decimated to few triangles, still run through all points along them.
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 4);
  const PreparedSurface prepared(
    cube, 4, Sharp, { std::vector<double>(cube.Points.size(), 10.0), {} });
  ASSERT_LT(prepared.GetSurface()->Triangles.size(), cube.Triangles.size() / 4);
  const std::vector<char> isFeature = prepared.FindFeatures(Sharp);
  const TriangleMesh& mesh = prepared.GetGeometry().Mesh;
  double length = 0.0;
  Index onFeatures = 0;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (isFeature[e] == 0)
    {
      continue;
    }
    const Index h = mesh.HalfEdge(e);
    const std::vector<Index> path =
      prepared.PathAlong(mesh.Point(mesh.Tail(h)), mesh.Point(mesh.Head(h)));
    EXPECT_EQ(path.front(), mesh.Point(mesh.Tail(h)));
    EXPECT_EQ(path.back(), mesh.Point(mesh.Head(h)));
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
    {
      length +=
        (prepared.GetSurface()->Points[path[k + 1]] - prepared.GetSurface()->Points[path[k]])
          .norm();
      ++onFeatures;
    }
  }
  // Twelve edges of 16 parts each.
  EXPECT_EQ(onFeatures, 12 * 16);
  const double side = std::sqrt(AreaOf(cube) / 6.0);
  EXPECT_NEAR(length, 12.0 * side, 1e-9);
}

TEST(PreparedField, IsOnlyForTheInputItWasPreparedFor)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 2);
  const PreparedField field(cube, 4, Sharp, {}, {}, ShapeAlignment{ 0.25, 1.5 }, Progress());
  EXPECT_TRUE(field.IsFor(4, Sharp, {}, {}, ShapeAlignment{ 0.25, 1.5 }));
  EXPECT_FALSE(field.IsFor(6, Sharp, {}, {}, ShapeAlignment{ 0.25, 1.5 }));
  EXPECT_FALSE(
    field.IsFor(4, FeatureSettings{ true, 100.0, 0.5, 0.0 }, {}, {}, ShapeAlignment{ 0.25, 1.5 }));
  EXPECT_FALSE(field.IsFor(4, Sharp, { std::vector<double>(cube.Points.size(), 1.0), {} }, {},
    ShapeAlignment{ 0.25, 1.5 }));
  EXPECT_FALSE(field.IsFor(4, Sharp, {}, cube.Points, ShapeAlignment{ 0.25, 1.5 }));
  EXPECT_FALSE(field.IsFor(4, Sharp, {}, {}, ShapeAlignment{ 0.5, 1.5 }));
  EXPECT_FALSE(field.IsFor(4, Sharp, {}, {}, ShapeAlignment{ 0.25, 1.0 }));
  // The field follows the features: one of its directions is along each of their edges, up to the
  // vertices' tangent planes.
  const SurfaceGeometry& geometry = field.GetGeometry();
  Index features = 0;
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = geometry.Mesh.HalfEdge(e);
    if (field.GetFeatures()[e] != 0 && field.GetFrameless()[geometry.Mesh.Tail(h)] == 0)
    {
      const double turns = field.GetMatching().AngleAtTail(geometry, h) / (0.5 * Pi);
      EXPECT_NEAR(turns, std::round(turns), 0.1);
      ++features;
    }
  }
  EXPECT_GT(features, 12);
}

TEST(PreparedField, KnowsWhichPartOfTheKeptEdgesItCrosses)
{
  const Surface square = Meshes::Square(8);
  const auto crossed = [&](double angle)
  {
    const std::vector<Vector3> directions(
      square.Points.size(), Vector3(std::cos(angle), std::sin(angle), 0.0));
    return PreparedField(square, 4, Sharp, {}, directions, ShapeAlignment{ 0.25, 1.5 }, Progress())
      .GetPartCrossed();
  };
  EXPECT_EQ(crossed(0.0), 0.0);
  EXPECT_EQ(crossed(0.5 * Pi + 0.2), 0.0);
  // The corners have no frame.
  EXPECT_GT(crossed(0.6), 0.8);
  EXPECT_LE(crossed(0.6), 1.0);
  // Of the edges of a cube those along x and y.
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 2);
  for (const bool isAcross : { false, true })
  {
    const std::vector<Vector3> directions(
      cube.Points.size(), isAcross ? Vector3(0.7, 0.7, 0.0) : Vector3(1.0, 0.0, 0.0));
    const double part =
      PreparedField(cube, 4, Sharp, {}, directions, ShapeAlignment{ 0.25, 1.5 }, Progress())
        .GetPartCrossed();
    EXPECT_TRUE(isAcross ? part > 0.5 : part < 0.1) << part;
  }
  EXPECT_EQ(PreparedField(square, 4, Sharp, {}, {}, ShapeAlignment{ 0.25, 1.5 }, Progress())
              .GetPartCrossed(),
    0.0);
}

TEST(WantedSizes, AreaIsInUnitsOfTheSize)
{
  const Surface square = Meshes::Square(4, 3.0);
  const std::vector<double> half(square.Points.size(), 0.5);
  EXPECT_NEAR(RelativeArea(square, half), 36.0, 1e-12);
  const std::vector<double> clamped = ClampedSizes({ 0.01, 100.0, -1.0, 2.0, std::nan("") }, 6);
  EXPECT_EQ(clamped, (std::vector<double>{ 0.125, 8.0, 1.0, 2.0, 1.0, 1.0 }));
}

TEST(WantedSizes, NarrowSurfacesGetTheEdgeLengthOfTheirBoundary)
{
  // Its faces all touch the boundary, which is 200.2 long.
  const Surface strip = Meshes::Transformed(
    Meshes::Square(8), Eigen::Vector3d(100.0, 0.1, 1.0).asDiagonal(), Vector3::Zero());
  const SurfaceGeometry geometry(strip);
  WantedSizes sizes;
  sizes.AtVertices.assign(geometry.Positions.size(), 1.0);
  sizes.EdgeLength = std::sqrt(10.0 / 5000.0);
  sizes.MapLength = 2.0 * sizes.EdgeLength;
  WantedSizes same = sizes;
  same.LengthenFor(geometry, 5000);
  EXPECT_EQ(same.EdgeLength, sizes.EdgeLength);
  sizes.LengthenFor(geometry, 50);
  EXPECT_NEAR(sizes.EdgeLength, 200.2 / (8.0 * 50.0), 1e-9);
  EXPECT_NEAR(sizes.MapLength, 2.0 * sizes.EdgeLength, 1e-12);
  EXPECT_NEAR(sizes.PerLength().front() * sizes.MapLength, 1.0, 1e-12);
  EXPECT_NEAR(sizes.HalfLengths().front(), 0.5 * sizes.EdgeLength, 1e-12);
}

TEST(SizeAdvice, NamesALengthThatMakesEightFaces)
{
  // A unit square has one face of length 1, and eight of length 1 / sqrt(8).
  const SurfaceGeometry geometry(Meshes::Square(4));
  const TriangleMesh::Component& component = geometry.Mesh.GetComponents().front();
  SizeAdvice large(1.0, 4);
  large.AddComponent(geometry, component, std::vector<double>(geometry.Positions.size(), 1.0));
  ASSERT_EQ(large.GetSentences().size(), 1U);
  EXPECT_NE(large.GetSentences().front().find("0.354"), std::string::npos);
  SizeAdvice small(0.35, 4);
  small.AddComponent(
    geometry, component, std::vector<double>(geometry.Positions.size(), 1.0 / 0.35));
  EXPECT_TRUE(small.GetSentences().empty());
}
