// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Refinement/LongEdges.h"
#include "Refinement/Thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
Vector3 OnCircle(int k, int sides, double z)
{
  const double angle = 2.0 * Pi * k / sides;
  return { std::cos(angle), std::sin(angle), z };
}

/// Needles from the rim of a circle of radius 1 to its middle, which is raised.
Surface Cone(int sides, double height)
{
  Surface cone;
  cone.Points.emplace_back(0.0, 0.0, height);
  for (int k = 0; k < sides; ++k)
  {
    cone.Points.push_back(OnCircle(k, sides, 0.0));
    cone.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % sides });
  }
  return cone;
}

enum class Lids
{
  None,
  /// Triangles from their middles.
  Fans,
  /// Triangles between opposite points, in zigzag.
  Strips
};

/// A wall of needles between circles of radius 1, and height 2.
Surface CylinderOfNeedles(int sides, Lids lids)
{
  Surface cylinder;
  for (int k = 0; k < 2 * sides; ++k)
  {
    cylinder.Points.push_back(OnCircle(k % sides, sides, k < sides ? 0.0 : 2.0));
  }
  for (int k = 0; k < sides; ++k)
  {
    const Index a = k;
    const Index b = (k + 1) % sides;
    cylinder.Triangles.push_back({ a, b, b + sides });
    cylinder.Triangles.push_back({ a, b + sides, a + sides });
  }
  for (const Index first : { 0, sides })
  {
    const auto add = [&](Index a, Index b, Index c) {
      cylinder.Triangles.push_back(first == 0 ? Triangle{ a, c, b } : Triangle{ a, b, c });
    };
    if (lids == Lids::Fans)
    {
      const auto middle = static_cast<Index>(cylinder.Points.size());
      cylinder.Points.emplace_back(0.0, 0.0, first == 0 ? 0.0 : 2.0);
      for (int k = 0; k < sides; ++k)
      {
        add(middle, first + k, first + (k + 1) % sides);
      }
    }
    Index low = 0;
    Index high = sides - 1;
    for (bool isLow = true; lids == Lids::Strips && high - low > 1; isLow = !isLow)
    {
      add(first + low, first + (isLow ? low + 1 : high - 1), first + high);
      low += isLow ? 1 : 0;
      high -= isLow ? 0 : 1;
    }
  }
  return cylinder;
}

RemeshResult MeshOf(const Surface& surface, Index faces)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

constexpr double EdgeLength = 0.05;

/// What a decimation leaves, whose features are the edges of the circles.
std::vector<Triangle> Thinned(const Surface& surface)
{
  const SurfaceGeometry geometry(surface);
  const Decimation::Limits limits =
    DecimationLimits(geometry, std::vector<double>(surface.Points.size(), EdgeLength), true, {});
  std::vector<char> isFeature(geometry.Mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = geometry.Mesh.HalfEdge(e);
    // Of a circle of thousands of points; all other edges are longer.
    const double step =
      (geometry.Positions[geometry.Mesh.Head(h)] - geometry.Positions[geometry.Mesh.Tail(h)])
        .norm();
    isFeature[e] = step < 5e-4 ? 1 : 0;
  }
  Decimation decimation(geometry.Mesh, geometry.Positions, isFeature, limits);
  decimation.Run();
  return TrianglesLeft(geometry.Mesh, decimation);
}

/// The largest distance of the middle of a chord of the lower circle from it: of the triangles that
/// have point 0 or are on a wall.
double Sagitta(const Surface& surface, const std::vector<Triangle>& triangles)
{
  double largest = 0.0;
  for (const Triangle& t : triangles)
  {
    const auto level = [&](int c) { return surface.Points[t[c]].z(); };
    const bool isOfLid = level(0) == level(1) && level(1) == level(2) && t[0] != 0;
    for (int c = 0; c < 3 && !isOfLid; ++c)
    {
      const Vector3& p = surface.Points[t[c]];
      const Vector3& q = surface.Points[t[(c + 1) % 3]];
      const bool isChord =
        p.z() == 0.0 && q.z() == 0.0 && std::min(p.norm(), q.norm()) > 1.0 - 1e-9;
      largest = std::max(largest, isChord ? 1.0 - (0.5 * (p + q)).norm() : 0.0);
    }
  }
  return largest;
}
}

TEST(Needles, AreMuchThinnerThanFacesAndLonger)
{
  EXPECT_FALSE(HasNeedles(Meshes::Disk(30), 0.1));
  // Around a point.
  EXPECT_TRUE(HasNeedles(Cone(51, 0.0), 0.1));
  EXPECT_FALSE(HasNeedles(Cone(50, 0.0), 0.1));
  // Sides of .006 beside faces of .1; of .1 they are as wide as faces.
  EXPECT_TRUE(HasNeedles(CylinderOfNeedles(1000, Lids::None), 0.1));
  EXPECT_FALSE(HasNeedles(CylinderOfNeedles(64, Lids::None), 0.1));
  EXPECT_FALSE(HasNeedles(CylinderOfNeedles(1000, Lids::None), 3.0));
}

TEST(Needles, BetweenLongEdgesOfTheSameLengthAreThinnedAllTheSame)
{
  // All needles of a cone are of one length, those of a wall but for the slant.
  for (const Surface& surface : { Cone(20000, 0.0), Cone(20000, 2.0),
         CylinderOfNeedles(20000, Lids::Fans), CylinderOfNeedles(20000, Lids::None) })
  {
    const std::vector<Triangle> left = Thinned(surface);
    // Chords that are a tenth of the length off a circle of radius 1 are .2 long; those that count
    // each step are a quarter as long at least.
    const auto circles = static_cast<double>(surface.Triangles.size()) / 20000.0;
    EXPECT_LT(static_cast<double>(left.size()), circles * 2.0 * Pi / 0.05);
    EXPECT_GT(static_cast<double>(left.size()), circles * 2.0 * Pi / 0.21);
    EXPECT_LT(Sagitta(surface, left), 0.1 * EdgeLength + 1e-6);
  }
}

TEST(Needles, HaveMeshesAsThoseOfFewerOnesHave)
{
  struct Case
  {
    std::string Name;
    Surface Given;
    Index Irregular;
  };
  for (const Case& one : { Case{ "disk", Cone(20000, 0.0), 4 }, Case{ "cone", Cone(20000, 2.0), 8 },
         Case{ "fans", CylinderOfNeedles(12000, Lids::Fans), 8 },
         Case{ "strips", CylinderOfNeedles(12000, Lids::Strips), 8 } })
  {
    const RemeshResult mesh = MeshOf(one.Given, 1000);
    EXPECT_EQ(Meshes::FlawOf(mesh), "") << one.Name;
    EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 1000.0, 60.0) << one.Name;
    EXPECT_LE(mesh.Triangles, 2) << one.Name;
    EXPECT_LE(mesh.IrregularVertices, one.Irregular) << one.Name;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.4) << one.Name;
    EXPECT_EQ(mesh.TurnedFaces, 0) << one.Name;
    EXPECT_LT(mesh.MaximumDistance, 0.15 * mesh.EdgeLength) << one.Name;
    EXPECT_LT(mesh.MaximumDistanceToMesh, 0.15 * mesh.EdgeLength) << one.Name;
  }
}
