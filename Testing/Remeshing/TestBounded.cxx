// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Memory and time of a mesh grow with the surface and the faces, whatever the surface is: numbers
// that they are proportional to.

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Parametrization/ParametrizationVariables.h"
#include "Remesh.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
/// The numbers of free integers, and of terms of all corners' coordinates, of which there are two a
/// corner.
struct Counts
{
  explicit Counts(const CutMesh& mesh)
  {
    ParametrizationVariables variables(mesh);
    for (Index v = 0; v < variables.Solved.GetNumberOfVariables(); ++v)
    {
      this->Integers += variables.Solved.IsFree(v) && variables.Solved.IsInteger(v) ? 1 : 0;
    }
    for (Index t = 0; t < static_cast<Index>(mesh.Triangles.size()); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const SymbolicGridPoint corner = variables.Corner(t, c);
        this->Terms += variables.Solved.Resolve(corner.A).size();
        this->Terms += variables.Solved.Resolve(corner.B).size();
      }
    }
    this->PerCoordinate =
      static_cast<double>(this->Terms) / (6.0 * static_cast<double>(mesh.Triangles.size()));
  }

  std::size_t Integers = 0;
  std::size_t Terms = 0;
  double PerCoordinate = 0.0;
};

/// Expects a mesh of a noisy body that has hardly more irregular vertices than the body without noise.
void ExpectMeshOfShape(const Surface& surface, Index faces)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(surface)).Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_LE(mesh.IrregularVertices, 30);
  EXPECT_LE(mesh.Triangles, 15);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.1);
  const auto wanted = static_cast<double>(faces);
  EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), wanted, 0.1 * wanted);
}
}

TEST(Bounded, CoordinatesDependOnFewVariablesHoweverManyConesThereAre)
{
  // A third of the triangles of a random field have cones.
  for (const int degree : { 4, 6 })
  {
    double before = 0.0;
    for (const int levels : { 2, 3, 4 })
    {
      const CutExample example = CutExample::Random(Meshes::Icosphere(levels), degree, 3);
      const Counts counts(example.Mesh);
      const std::size_t cones = example.Mesh.Cones.size();
      EXPECT_GT(cones, std::size_t(50) << (2 * (levels - 2)));
      // No integers were lost.
      EXPECT_EQ(counts.Integers, 2 * (cones - 2));
      EXPECT_LT(counts.PerCoordinate, 8.0);
      if (levels == 4)
      {
        EXPECT_LT(counts.PerCoordinate, 1.2 * before);
      }
      before = counts.PerCoordinate;
    }
  }
}

TEST(Bounded, HandlesAndLoopsOfTheBoundaryHaveFewVariablesToo)
{
  // Genus 2, and a field of many cones.
  const CutExample closed =
    CutExample::Random(Meshes::FlatlySubdivided(Meshes::DoubleTorus(), 1), 4, 2);
  const Counts counts(closed.Mesh);
  ASSERT_GT(closed.Mesh.Cones.size(), 100U);
  EXPECT_EQ(counts.Integers, 2 * (closed.Mesh.Cones.size() + 2));
  EXPECT_LT(counts.PerCoordinate, 8.0);
  const CutExample open = CutExample::Random(Meshes::PlateWithHole(48, 12, 0.5, true), 4, 2);
  ASSERT_GT(open.Mesh.Cones.size(), 100U);
  EXPECT_LT(Counts(open.Mesh).PerCoordinate, 12.0);
}

TEST(Bounded, NoiseOfOneEdgeLeavesTheConesOfTheShape)
{
  const auto surface = std::make_shared<Surface>(Meshes::Roughened(Meshes::Icosphere(4), 1.0, 7));
  Remesh remesh(surface);
  for (const Index faces : { 10, 300 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    const RemeshResult mesh = remesh.Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "") << faces;
    // Those of a sphere are eight, those of the noise hundreds.
    EXPECT_LE(mesh.IrregularVertices, 30) << faces;
    EXPECT_LE(mesh.Triangles, static_cast<Index>(mesh.Faces.size() / 50)) << faces;
    EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), faces, 4.0 + 0.2 * faces);
    const auto isSaid = [](const std::string& note) { return note.find("rough") < 20; };
    EXPECT_TRUE(std::any_of(mesh.Notes.begin(), mesh.Notes.end(), isSaid)) << faces;
    // Its points lie on the rough surface, not on the smooth one.
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      Vector3 place = Vector3::Zero();
      for (int c = 0; c < 3; ++c)
      {
        place +=
          mesh.SourceWeights[v][c] * surface->Points[surface->Triangles[mesh.SourceTriangle[v]][c]];
      }
      ASSERT_LT((place - mesh.Points[v]).norm(), 1e-9);
    }
  }
  RemeshOptions options;
  options.NumberOfFaces = 300;
  const RemeshResult again = remesh.Compute(options);
  options.NumberOfThreads = 3;
  EXPECT_EQ(again.Points, Remesh(surface).Compute(options).Points);
}

/// A field on a body with little noise has fewer singularities than on one with much; they are those of noise all
/// the same, where the body needs none of them.
TEST(Bounded, NoiseOfLessThanAnEdgeDoesToo)
{
  for (const double noise : { 0.5, 0.7 })
  {
    ExpectMeshOfShape(Meshes::Roughened(Meshes::Icosphere(5), noise, 7), 1500);
  }
}

/// Triangles between sharp edges of noise are no facets: split, they would make features of the noise, by the
/// thousand.
TEST(Bounded, NoiseOnAsManyTrianglesAsFacesDoesToo)
{
  ExpectMeshOfShape(Meshes::Roughened(Meshes::Icosphere(3), 1.2, 7), 1300);
}

/// Where many edges are sharp and no features, few singularities more than the shape needs are those of noise.
TEST(Bounded, NoiseBetweenFeaturesIsRecognizedByFewSingularities)
{
  ExpectMeshOfShape(Meshes::Roughened(Meshes::ChamferedCube(20), 0.5, 7), 3000);
}
