// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/CutGraph.h"
#include "Charts/CutMesh.h"
#include "Charts/FieldMatching.h"
#include "Meshes/Surfaces.h"
#include "Parametrization/IntegerGridMap.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <random>

using namespace DirectionFields;

namespace
{
/// A surface with a random field, which has many singularities, and all that a map needs.
struct Example
{
  Example(const Surface& surface, int degree, unsigned seed)
    : Geometry(surface)
    , Section(RandomSection(this->Geometry, seed))
    , Charts(this->Geometry, degree, this->Section)
    , IsFrameless(FramelessVertices(this->Geometry, degree, {}))
    , Features(this->Geometry, this->Charts, {}, this->IsFrameless,
        std::vector<double>(this->Geometry.Mesh.GetComponents().size(), 0.1))
    , Part(this->Geometry.Mesh.GetComponents().front())
    , Jumps(this->Geometry, this->Part, this->Charts, this->Features, this->IsFrameless)
  {
  }

  /// A few values that are interpolated along the order of the vertices.
  static std::vector<Complex> RandomSection(const SurfaceGeometry& geometry, unsigned seed)
  {
    std::mt19937 engine(seed);
    std::vector<Complex> section(geometry.Mesh.GetNumberOfVertices());
    for (Complex& z : section)
    {
      z = std::polar(1.0, engine() / 4294967296.0 * 2.0 * Pi);
    }
    return section;
  }

  SurfaceGeometry Geometry;
  std::vector<Complex> Section;
  FieldMatching Charts;
  std::vector<char> IsFrameless;
  FeatureLines Features;
  const TriangleMesh::Component& Part;
  CutGraph Jumps;
};

std::vector<Surface> Examples()
{
  return { Meshes::Icosphere(2), Meshes::Torus(12, 9), Meshes::DoubleTorus(), Meshes::Disk(4),
    Meshes::Cylinder(9, 4, 1.0), Meshes::PlateWithHole(12, 4, 0.4, true), Meshes::Potato(2) };
}
}

TEST(FieldMatching, IndicesAreThoseOfTheField)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const Example example(surface, degree, 7);
      EXPECT_EQ(example.Charts.SingularityIndex,
        SingularityIndices(example.Geometry, degree, example.Section));
    }
  }
}

TEST(FieldMatching, MatchingsAroundATriangleSumUpToMinusItsIndex)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const Example example(surface, degree, 8);
      const TriangleMesh& mesh = example.Geometry.Mesh;
      for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
      {
        int sum = example.Charts.SingularityIndex[t];
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
        {
          sum += example.Charts.MatchingAlong(mesh, h);
        }
        EXPECT_EQ(((sum % degree) + degree) % degree, 0);
      }
    }
  }
}

TEST(CutGraph, RegularTrianglesCloseUpWhateverTheJumpsAre)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const Example example(surface, degree, 9);
      const TriangleMesh& mesh = example.Geometry.Mesh;
      const auto along = [&](Index h)
      {
        SymbolicTransition t{ example.Charts.Matching[mesh.Edge(h)],
          example.Jumps.At(mesh.Edge(h)) };
        return mesh.GivesDirection(h) ? t : t.Inverse(degree);
      };
      for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
      {
        if (example.Charts.SingularityIndex[t] != 0 || t == example.Jumps.GetSeed())
        {
          continue;
        }
        const SymbolicTransition around = SymbolicTransition::Composed(
          SymbolicTransition::Composed(along(3 * t), along(3 * t + 1), degree), along(3 * t + 2),
          degree);
        // The jumps cancel where their sums with the powers of zeta do.
        const IntegerGrid plane(degree);
        std::vector<Complex> sums(example.Jumps.GetNumberOfVariables(), 0.0);
        for (const Jump& jump : around.Jumps)
        {
          sums[jump.Variable] += plane.Root(jump.Turn);
        }
        EXPECT_EQ(around.Turn, 0);
        for (const Complex& sum : sums)
        {
          EXPECT_LT(std::abs(sum), 1e-12);
        }
      }
    }
  }
}

TEST(CutGraph, GoTwiceAroundEachHandle)
{
  EXPECT_EQ(Example(Meshes::Icosphere(2), 4, 1).Jumps.GetNumberOfLoops(), 0);
  EXPECT_EQ(Example(Meshes::Torus(12, 9), 4, 1).Jumps.GetNumberOfLoops(), 2);
  EXPECT_EQ(Example(Meshes::DoubleTorus(), 4, 1).Jumps.GetNumberOfLoops(), 4);
  EXPECT_EQ(Example(Meshes::Cylinder(9, 4, 1.0), 4, 1).Jumps.GetNumberOfLoops(), 0);
}

TEST(IntegerGridMap, AgreesAcrossEveryEdgeExactly)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const Example example(surface, degree, 10);
      const CutMesh mesh(example.Geometry, example.Part, example.Charts, example.Features,
        example.IsFrameless, example.Jumps, example.Section);
      IntegerGridMap::Settings settings;
      settings.PerLength.assign(mesh.Positions.size(), 10.0);
      const IntegerGridMap map(mesh, settings);
      ASSERT_EQ(map.GetFailure(), nullptr);
      const IntegerGrid plane(degree);
      const auto next = [](std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
      for (std::size_t h = 0; h < map.GetCorners().size(); ++h)
      {
        const Index twin = mesh.Triangles[h / 3].Twin[h % 3];
        if (twin == None)
        {
          continue;
        }
        const auto g = static_cast<std::size_t>(twin);
        EXPECT_EQ(plane.Apply(map.GetAcross()[h], map.GetCorners()[g]), map.GetCorners()[next(h)]);
        EXPECT_EQ(plane.Apply(map.GetAcross()[h], map.GetCorners()[next(g)]), map.GetCorners()[h]);
        EXPECT_TRUE(IntegerGrid::IsLatticePoint(map.GetAcross()[h].Shift));
      }
    }
  }
}

TEST(IntegerGridMap, ConesAreLatticePointsAndFeaturesAreLinesOfTheLattice)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const Example example(surface, degree, 11);
      const CutMesh mesh(example.Geometry, example.Part, example.Charts, example.Features,
        example.IsFrameless, example.Jumps, example.Section);
      IntegerGridMap::Settings settings;
      settings.PerLength.assign(mesh.Positions.size(), 10.0);
      const IntegerGridMap map(mesh, settings);
      std::vector<char> isCone(mesh.Positions.size(), 0);
      for (const CutMesh::Cone& cone : mesh.Cones)
      {
        isCone[cone.Vertex] = 1;
      }
      for (std::size_t h = 0; h < map.GetCorners().size(); ++h)
      {
        if (isCone[mesh.Triangles[h / 3].Vertex[h % 3]] != 0)
        {
          EXPECT_TRUE(IntegerGrid::IsLatticePoint(map.GetCorners()[h]));
        }
      }
      const IntegerGrid plane(degree);
      for (const CutMesh::IsolineEdge& edge : mesh.Isolines)
      {
        const std::size_t h = 3 * edge.Triangle;
        const GridPoint p = plane.Turned(map.GetCorners()[h + edge.Corner], -edge.Axis);
        const GridPoint q = plane.Turned(map.GetCorners()[h + (edge.Corner + 1) % 3], -edge.Axis);
        EXPECT_EQ(p.B, q.B);
        EXPECT_EQ(p.B % IntegerGrid::Unit, 0);
      }
    }
  }
}
