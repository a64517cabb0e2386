// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/CutMesh.h"

#include "Charts/FeatureIsolines.h"
#include "Features/KeptFeatures.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

#include <map>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
std::vector<Surface> Examples()
{
  return { Meshes::Icosphere(2), Meshes::Torus(12, 9), Meshes::DoubleTorus(), Meshes::Disk(4),
    Meshes::Cylinder(9, 4, 1.0), Meshes::PlateWithHole(12, 4, 0.4, true) };
}

std::vector<char> SharpEdges(const Surface& surface)
{
  return FindFeatures(SurfaceGeometry(surface), { true, 40.0, 0.5, 0.0 });
}
}

TEST(CutMesh, HasTheTopologyOfTheComponent)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 31);
      const CutMesh& mesh = example.Mesh;
      std::size_t sides = 0;
      for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
      {
        for (int c = 0; c < 3; ++c)
        {
          const CutMesh::MapTriangle& triangle = mesh.Triangles[t];
          const Index twin = triangle.Twin[c];
          sides += twin == None ? 2 : 1;
          if (twin == None)
          {
            continue;
          }
          const CutMesh::MapTriangle& other = mesh.Triangles[twin / 3];
          EXPECT_EQ(other.Twin[twin % 3], static_cast<Index>(3 * t + c));
          EXPECT_EQ(other.Vertex[twin % 3], triangle.Vertex[(c + 1) % 3]);
          EXPECT_EQ(other.Vertex[(twin + 1) % 3], triangle.Vertex[c]);
        }
      }
      const TriangleMesh& before = example.Geometry.Mesh;
      EXPECT_EQ(static_cast<Index>(mesh.Positions.size()) - static_cast<Index>(sides / 2) +
          static_cast<Index>(mesh.Triangles.size()),
        before.GetNumberOfVertices() - before.GetNumberOfEdges() + before.GetNumberOfTriangles());
    }
  }
}

TEST(CutMesh, HasAConeOfItsIndexInEachSingularTriangle)
{
  for (const int degree : { 4, 6 })
  {
    const CutExample example = CutExample::Random(Meshes::Icosphere(2), degree, 32);
    Index singular = 0;
    int sum = 0;
    for (const int index : example.Matching.SingularityIndex)
    {
      singular += index != 0 ? 1 : 0;
    }
    for (const int index : example.Mesh.ConeIndex)
    {
      sum += index;
    }
    // All around a sphere the indices sum up to n chi.
    EXPECT_EQ(sum, 2 * degree);
    EXPECT_EQ(static_cast<Index>(example.Mesh.Positions.size()),
      example.Geometry.Mesh.GetNumberOfVertices() + singular);
  }
}

TEST(CutMesh, WeightsAreHalfTheCotangents)
{
  const CutExample example = CutExample::AlongX(Meshes::Square(3), 4);
  for (const CutMesh::MapTriangle& t : example.Mesh.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Vector3& tip = example.Mesh.Positions[t.Vertex[(c + 2) % 3]];
      const Vector3 u = example.Mesh.Positions[t.Vertex[c]] - tip;
      const Vector3 v = example.Mesh.Positions[t.Vertex[(c + 1) % 3]] - tip;
      EXPECT_NEAR(t.Weight[c], 0.5 * u.dot(v) / u.cross(v).norm(), 1e-9);
      EXPECT_NEAR(std::abs(t.Target[c]), (u - v).norm(), 1e-9);
    }
  }
}

TEST(SymbolicTransition, InversesAndProductsCancel)
{
  for (const int degree : { 4, 6 })
  {
    const SymbolicTransition s{ 1, { { 0, 2 }, { 3, 1 } } };
    const SymbolicTransition t{ degree - 1, { { 1, 0 }, { 3, 3 } } };
    SymbolicTransition product = SymbolicTransition::Composed(s, s.Inverse(degree), degree);
    product.Simplify(degree);
    EXPECT_TRUE(product.IsIdentity());
    product = SymbolicTransition::Composed(SymbolicTransition::Composed(s, t, degree),
      SymbolicTransition::Composed(t.Inverse(degree), s.Inverse(degree), degree), degree);
    product.Simplify(degree);
    EXPECT_TRUE(product.IsIdentity());
    EXPECT_FALSE(SymbolicTransition::Composed(s, t, degree).IsIdentity());
  }
}

TEST(FeatureLines, EveryFeatureEdgeIsAStepOfOneChain)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 2);
  const CutExample example(
    cube, 4, [](const SurfaceGeometry& geometry) { return Meshes::RandomSection(geometry, 3); },
    SharpEdges(cube));
  const TriangleMesh& mesh = example.Geometry.Mesh;
  std::map<Index, int> steps;
  for (const FeatureLines::Chain& chain : example.Features.Chains)
  {
    for (std::size_t k = 0; k < chain.Steps.size(); ++k)
    {
      ++steps[mesh.Edge(chain.Steps[k].HalfEdge)];
      if (k > 0)
      {
        EXPECT_EQ(
          FeatureLines::Start(mesh, chain.Steps[k]), FeatureLines::End(mesh, chain.Steps[k - 1]));
      }
    }
  }
  // The twelve edges of a cube, each of them divided in four; its eight corners have no frame.
  EXPECT_EQ(example.Features.Chains.size(), 12U);
  EXPECT_EQ(steps.size(), 48U);
  for (const auto& [edge, count] : steps)
  {
    EXPECT_EQ(count, 1);
    EXPECT_NE(example.Features.IsFeature[edge], 0);
  }
  EXPECT_EQ(std::count(example.IsFrameless.begin(), example.IsFrameless.end(), 1), 8);
}

TEST(FeatureIsolines, EveryIsolineEdgeBelongsToOne)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 2);
  const CutExample example(
    cube, 4, [](const SurfaceGeometry& geometry) { return Meshes::RandomSection(geometry, 3); },
    SharpEdges(cube));
  const CutMesh& mesh = example.Mesh;
  std::vector<char> isPoint(mesh.Positions.size(), 0);
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    isPoint[cone.Vertex] = 1;
  }
  const std::vector<FeatureIsoline> isolines = FindFeatureIsolines(mesh, isPoint);
  std::vector<int> count(mesh.Isolines.size(), 0);
  for (const FeatureIsoline& isoline : isolines)
  {
    Index before = None;
    for (const FeatureIsoline::Step& step : isoline.Steps)
    {
      const CutMesh::IsolineEdge& edge = mesh.Isolines[step.Isoline];
      ++count[step.Isoline];
      const Index start = EndOf(mesh, edge, step.IsReversed);
      EXPECT_TRUE(before == None ? isPoint[start] != 0 : before == start && isPoint[start] == 0);
      before = EndOf(mesh, edge, !step.IsReversed);
    }
    EXPECT_NE(isPoint[before], 0);
  }
  EXPECT_EQ(isolines.size(), 12U);
  EXPECT_EQ(count, std::vector<int>(mesh.Isolines.size(), 1));
}
