// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/NarrowCorners.h"

#include "Parametrization/ComponentMap.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
constexpr int Spokes = 24;
constexpr int Rings = 3;

/// The point at a multiple of 15 degrees, 0 to 3 from the center.
Index PointAt(int spoke, int ring)
{
  return ring == 0 ? 0 : 1 + (ring - 1) * Spokes + spoke % Spokes;
}

Surface FlatFan()
{
  Surface surface;
  surface.Points.push_back(Vector3::Zero());
  for (int ring = 1; ring <= Rings; ++ring)
  {
    for (int spoke = 0; spoke < Spokes; ++spoke)
    {
      const double angle = 2.0 * Pi * spoke / Spokes;
      surface.Points.emplace_back(ring * std::cos(angle), ring * std::sin(angle), 0.0);
    }
  }
  for (int spoke = 0; spoke < Spokes; ++spoke)
  {
    surface.Triangles.push_back({ 0, PointAt(spoke, 1), PointAt(spoke + 1, 1) });
    for (int ring = 1; ring < Rings; ++ring)
    {
      surface.Triangles.push_back(
        { PointAt(spoke, ring), PointAt(spoke, ring + 1), PointAt(spoke + 1, ring + 1) });
      surface.Triangles.push_back(
        { PointAt(spoke, ring), PointAt(spoke + 1, ring + 1), PointAt(spoke + 1, ring) });
    }
  }
  return surface;
}

/// The fan with a feature from the center to the boundary, and one at an angle to it that ends inside.
struct Fan
{
  explicit Fan(int spoke)
    : Fan(spoke, SurfaceGeometry(FlatFan()).Mesh)
  {
  }

  /// The edge of a spoke from a ring to the next.
  Index EdgeAt(int spoke, int ring) const
  {
    return EdgeOf(this->Example.Geometry.Mesh, spoke, ring);
  }
  std::vector<Index> Narrow(double perLength) const
  {
    std::vector<Index> edges = EdgesInNarrowCorners(this->Example.Geometry, this->Example.Component,
      this->Example.Matching, this->Example.Features, this->Example.IsFrameless,
      this->Example.Settings(perLength).PerLength);
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  CutExample Example;

private:
  static Index EdgeOf(const TriangleMesh& mesh, int spoke, int ring)
  {
    for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
    {
      if (mesh.Point(mesh.Tail(h)) == PointAt(spoke, ring) &&
        mesh.Point(mesh.Head(h)) == PointAt(spoke, ring + 1))
      {
        return mesh.Edge(h);
      }
    }
    return None;
  }
  static std::vector<char> FeaturesOf(const TriangleMesh& mesh, int spoke)
  {
    std::vector<char> isFeature(mesh.GetNumberOfEdges(), 0);
    for (int ring = 0; ring < Rings; ++ring)
    {
      isFeature[EdgeOf(mesh, 0, ring)] = 1;
    }
    isFeature[EdgeOf(mesh, spoke, 0)] = isFeature[EdgeOf(mesh, spoke, 1)] = 1;
    return isFeature;
  }
  Fan(int spoke, const TriangleMesh& mesh)
    : Example(
        FlatFan(), 4,
        [](const SurfaceGeometry& geometry)
        {
          return Meshes::SectionAlong(
            geometry, 4, [](const Vector3&) { return Vector3(1.0, 0.0, 0.0); });
        },
        FeaturesOf(mesh, spoke))
  {
  }
};
}

TEST(NarrowCorners, AreThoseOfLessThanHalfAQuarterTurn)
{
  // A right angle has room for two lines of the grid.
  EXPECT_TRUE(Fan(6).Narrow(2.0).empty());
  EXPECT_TRUE(Fan(4).Narrow(2.0).empty());
  EXPECT_FALSE(Fan(2).Narrow(2.0).empty());
}

TEST(NarrowCorners, NameTheShorterFeatureUpToWhereThereIsRoom)
{
  // At 30 degrees the features are 0.75 edges apart at 1.5 edges from the corner.
  const Fan fan(2);
  const std::vector<Index> first = { fan.EdgeAt(2, 0) };
  EXPECT_EQ(fan.Narrow(2.0), first);
  std::vector<Index> both = { fan.EdgeAt(2, 0), fan.EdgeAt(2, 1) };
  std::sort(both.begin(), both.end());
  EXPECT_EQ(fan.Narrow(0.5), both);
}

TEST(ComponentMap, DropsFeaturesInNarrowCornersButNotTheBoundary)
{
  Fan fan(2);
  std::vector<ParametrizationCache> caches(1);
  const CutExample& example = fan.Example;
  ParametrizationInput input{ example.Geometry, example.Matching, example.Section, example.Features,
    example.IsFrameless, std::vector<double>(example.Geometry.Mesh.GetNumberOfVertices(), 2.0),
    caches };
  const ComponentMap map = MapComponent(input, example.Component);
  ASSERT_FALSE(map.Map.GetFailure());
  EXPECT_EQ(input.Features.IsFeature[fan.EdgeAt(2, 0)], 0);
  EXPECT_EQ(input.Features.IsFeature[fan.EdgeAt(0, 0)], 1);
  const TriangleMesh& mesh = example.Geometry.Mesh;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (mesh.Twin(mesh.HalfEdge(e)) == None)
    {
      EXPECT_EQ(input.Features.IsFeature[e], 1);
    }
  }
  // The remaining features are lines of the grid in the map.
  const IntegerGrid plane(4);
  std::size_t lines = 0;
  for (const CutMesh::IsolineEdge& edge : map.Mesh.Isolines)
  {
    const std::size_t h = 3 * edge.Triangle;
    const GridPoint p = plane.Turned(map.Map.GetCorners()[h + edge.Corner], -edge.Axis);
    EXPECT_EQ(p.B % IntegerGrid::Unit, 0);
    lines += edge.Edge == fan.EdgeAt(0, 0) ? 1 : 0;
    EXPECT_NE(edge.Edge, fan.EdgeAt(2, 0));
  }
  EXPECT_EQ(lines, 1U);
}
