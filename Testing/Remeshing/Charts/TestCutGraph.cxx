// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/CutGraph.h"

#include "Charts/FieldMatching.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
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
      const CutExample example = CutExample::Random(surface, degree, 7);
      EXPECT_EQ(example.Matching.SingularityIndex,
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
      const CutExample example = CutExample::Random(surface, degree, 8);
      const TriangleMesh& mesh = example.Geometry.Mesh;
      for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
      {
        int sum = example.Matching.SingularityIndex[t];
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
        {
          sum += example.Matching.MatchingAlong(mesh, h);
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
      const CutExample example = CutExample::Random(surface, degree, 9);
      const TriangleMesh& mesh = example.Geometry.Mesh;
      const auto along = [&](Index h)
      {
        SymbolicTransition t{ example.Matching.Matching[mesh.Edge(h)],
          example.Graph.At(mesh.Edge(h)) };
        return mesh.GivesDirection(h) ? t : t.Inverse(degree);
      };
      for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
      {
        if (example.Matching.SingularityIndex[t] != 0 || t == example.Graph.GetSeed())
        {
          continue;
        }
        const SymbolicTransition around = SymbolicTransition::Composed(
          SymbolicTransition::Composed(along(3 * t), along(3 * t + 1), degree), along(3 * t + 2),
          degree);
        // The jumps cancel where their sums with the powers of zeta do.
        const IntegerGrid plane(degree);
        std::vector<Complex> sums(example.Graph.GetNumberOfVariables(), 0.0);
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
  EXPECT_EQ(CutExample::Random(Meshes::Icosphere(2), 4, 1).Graph.GetNumberOfLoops(), 0);
  EXPECT_EQ(CutExample::Random(Meshes::Torus(12, 9), 4, 1).Graph.GetNumberOfLoops(), 2);
  EXPECT_EQ(CutExample::Random(Meshes::DoubleTorus(), 4, 1).Graph.GetNumberOfLoops(), 4);
  EXPECT_EQ(CutExample::Random(Meshes::Cylinder(9, 4, 1.0), 4, 1).Graph.GetNumberOfLoops(), 0);
}
