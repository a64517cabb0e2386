// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Decimation/Decimation.h"
#include "Geometry/DihedralAngles.h"
#include "Geometry/SurfaceGeometry.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// Edges sharper than 30 degrees.
std::vector<char> SharpEdges(const SurfaceGeometry& geometry)
{
  std::vector<char> isSharp;
  for (const double angle : DihedralAngles(geometry))
  {
    isSharp.push_back(std::abs(angle) > Pi / 6.0 ? 1 : 0);
  }
  return isSharp;
}

Surface Decimated(const Surface& surface, double length, double deviation = 0.1)
{
  const SurfaceGeometry geometry(surface);
  Decimation::Limits limits{ std::vector<double>(geometry.Mesh.GetNumberOfVertices(), length) };
  limits.Deviation = deviation;
  Decimation decimation(geometry.Mesh, geometry.Positions, SharpEdges(geometry), limits);
  decimation.Run();
  Surface left;
  left.Points = surface.Points;
  for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); ++t)
  {
    if (decimation.IsTriangle(t) && geometry.Mesh.IsFront(t))
    {
      Triangle corners{};
      for (int c = 0; c < 3; ++c)
      {
        corners[c] = geometry.Mesh.Point(decimation.Corner(3 * t + c));
      }
      left.Triangles.push_back(corners);
    }
  }
  return left;
}

int EulerCharacteristic(const TriangleMesh& mesh)
{
  return mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles();
}

/// The lengths of the edges that are sharp or on the boundary.
double FeatureLength(const Surface& surface)
{
  const SurfaceGeometry geometry(surface);
  const std::vector<char> isSharp = SharpEdges(geometry);
  double length = 0.0;
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = geometry.Mesh.HalfEdge(e);
    if (isSharp[e] != 0 || geometry.Mesh.Twin(h) == None)
    {
      length +=
        (geometry.Positions[geometry.Mesh.Head(h)] - geometry.Positions[geometry.Mesh.Tail(h)])
          .norm();
    }
  }
  return length;
}

double Area(const Surface& surface)
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
}

TEST(Decimation, ChordsOfARimAreAsNearAsTheyHaveToBe)
{
  // They would be as long as allowed, and four times as far away.
  constexpr double length = 0.4;
  constexpr double deviation = 0.01;
  const Surface disk = Decimated(Meshes::Disk(100), length, deviation);
  const SurfaceGeometry geometry(disk);
  double farthest = 0.0;
  int chords = 0;
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = geometry.Mesh.HalfEdge(e);
    if (geometry.Mesh.Twin(h) == None)
    {
      ++chords;
      farthest = std::max(farthest,
        1.0 -
          (0.5 *
            (geometry.Positions[geometry.Mesh.Head(h)] + geometry.Positions[geometry.Mesh.Tail(h)]))
            .norm());
    }
  }
  EXPECT_LT(chords, 200);
  EXPECT_LT(farthest, deviation * length + 1e-4);
}

TEST(Decimation, KeepsTheTopology)
{
  for (const Surface& surface :
    { Meshes::Icosphere(4), Meshes::Torus(60, 30), Meshes::DoubleTorus(), Meshes::Disk(20),
      Meshes::Cylinder(60, 20, 1.0), Meshes::PlateWithHole(60, 15, 0.3, true),
      Meshes::Joined(Meshes::Icosphere(3), Meshes::Torus(30, 20)), Meshes::Potato(4),
      Meshes::Roughened(Meshes::Icosphere(4), 0.3, 5), Meshes::Scrambled(Meshes::Disk(15), 2),
      Meshes::MoebiusStrip(40, 6), Meshes::ProjectivePlane(3) })
  {
    for (const double length : { 0.2, 1.0, 100.0 })
    {
      const TriangleMesh before(surface);
      const Surface left = Decimated(surface, length);
      const TriangleMesh after(left);
      EXPECT_EQ(EulerCharacteristic(before), EulerCharacteristic(after));
      ASSERT_EQ(before.GetComponents().size(), after.GetComponents().size());
      // The winding of a surface of one side is not that of its boundary.
      if (!before.GetComponents().front().IsCover)
      {
        EXPECT_EQ(Meshes::CountBoundaryLoops(surface), Meshes::CountBoundaryLoops(left));
      }
      EXPECT_EQ(after.GetRepairs().NonManifoldEdges, before.GetRepairs().NonManifoldEdges);
    }
  }
}

TEST(Decimation, LeavesFewTrianglesWhereTheSurfaceIsFlat)
{
  const Surface square = Meshes::Square(100);
  const Surface left = Decimated(square, 0.2);
  // Of 200 per unit of length and width about 2 / (sqrt(3) / 2 (0.2 / 2)^2) are left.
  EXPECT_LT(left.Triangles.size(), 600U);
  EXPECT_GT(left.Triangles.size(), 50U);
  EXPECT_NEAR(Area(left), 1.0, 1e-12);
  EXPECT_NEAR(FeatureLength(left), 4.0, 1e-12);
}

TEST(Decimation, KeepsFeatures)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 5);
  const double side = std::cbrt(std::pow(Area(cube) / 6.0, 1.5));
  const Surface left = Decimated(cube, 0.3 * side);
  EXPECT_LT(left.Triangles.size(), cube.Triangles.size() / 5);
  EXPECT_NEAR(FeatureLength(left), 12.0 * side, 1e-9 * side);
  EXPECT_NEAR(Area(left), 6.0 * side * side, 1e-9 * side * side);
}

TEST(Decimation, MovesTheSurfaceLessThanItMay)
{
  const Surface sphere = Meshes::Icosphere(5);
  for (const double length : { 0.2, 0.5 })
  {
    const Surface left = Decimated(sphere, length);
    EXPECT_LT(left.Triangles.size(), sphere.Triangles.size() / 4);
    double deepest = 0.0;
    for (const Triangle& t : left.Triangles)
    {
      const Vector3 middle = (left.Points[t[0]] + left.Points[t[1]] + left.Points[t[2]]) / 3.0;
      deepest = std::max(deepest, 1.0 - middle.norm());
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_LT((left.Points[t[c]] - left.Points[t[(c + 1) % 3]]).norm(), 1.001 * length);
      }
    }
    EXPECT_LT(deepest, Decimation::Limits().Deviation * length + 1e-3);
  }
}

TEST(Decimation, DoesNotDependOnThreads)
{
  const Surface surface = Meshes::Potato(6);
  std::vector<Triangle> first;
  for (const int number : { 1, 3 })
  {
    Threads threads(number);
    const Threads::Scope scope(threads);
    const Surface left = Decimated(surface, 0.1);
    if (first.empty())
    {
      first = left.Triangles;
      EXPECT_LT(first.size(), surface.Triangles.size() / 2);
    }
    EXPECT_EQ(first, left.Triangles);
  }
}

TEST(Decimation, KeepsPointsThatSheetsShare)
{
  // Three sheets along an edge, and bodies that meet in a point.
  Surface sheets = Meshes::Square(16);
  const auto count = static_cast<Index>(sheets.Points.size());
  std::vector<Index> number(count);
  for (Index p = 0; p < count; ++p)
  {
    const Vector3 place = sheets.Points[p];
    const bool isOn = std::abs(place[0]) < 1e-12;
    number[p] = isOn ? p : static_cast<Index>(sheets.Points.size());
    if (!isOn)
    {
      sheets.Points.emplace_back(0.0, place[1], place[0]);
    }
  }
  const std::vector<Triangle> flat = sheets.Triangles;
  for (const Triangle& t : flat)
  {
    sheets.Triangles.push_back({ number[t[0]], number[t[1]], number[t[2]] });
  }
  const TriangleMesh before(sheets);
  const TriangleMesh after(Decimated(sheets, 1.0));
  EXPECT_EQ(EulerCharacteristic(before), EulerCharacteristic(after));
  EXPECT_EQ(before.GetRepairs().NonManifoldEdges, after.GetRepairs().NonManifoldEdges);
  EXPECT_LT(after.GetNumberOfTriangles(), before.GetNumberOfTriangles() / 2);
}
