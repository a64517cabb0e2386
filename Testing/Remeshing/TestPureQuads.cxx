// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

using namespace DirectionFields;

namespace
{
Surface RoughCube(unsigned seed)
{
  return Meshes::Roughened(Meshes::FlatlySubdivided(Meshes::Cube(), 4), 0.3, seed);
}
}

TEST(Remesh, PureQuadsAreQuadsOnly)
{
  RemeshOptions options;
  options.NumberOfFaces = 800;
  options.PureQuads = true;
  for (const Surface& surface : { Meshes::Potato(4), Meshes::ChamferedCube(6) })
  {
    const RemeshResult mesh = Remesh(std::make_shared<Surface>(surface)).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Triangles, 0);
    EXPECT_NEAR(mesh.Quads, 800.0, 120.0);
  }
}

TEST(Remesh, PureQuadsAreTheMeshWithoutItsTriangles)
{
  // Edges of a shape in noise make triangles, but hardly any: the numbers are some for which they do.
  struct Case
  {
    unsigned Seed;
    Index Faces;
  };
  RemeshOptions options;
  Index triangles = 0;
  for (const Case& one : { Case{ 1, 400 }, Case{ 1, 600 }, Case{ 2, 600 } })
  {
    const auto surface = std::make_shared<Surface>(RoughCube(one.Seed));
    options.NumberOfFaces = one.Faces;
    options.PureQuads = false;
    const RemeshResult mixed = Remesh(surface).Compute(options);
    options.PureQuads = true;
    const RemeshResult pure = Remesh(surface).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(pure), "");
    EXPECT_EQ(pure.Triangles, 0);
    EXPECT_EQ(pure.KeptVertices, mixed.KeptVertices);
    EXPECT_NEAR(pure.Quads, mixed.Quads + mixed.Triangles, 0.05 * mixed.Quads);
    EXPECT_LT(pure.MaximumDistance, 1.3 * mixed.MaximumDistance);
    EXPECT_LE(pure.IrregularVertices, mixed.IrregularVertices + 4 * mixed.Triangles);
    EXPECT_GT(Meshes::LeastQuality(pure), 0.2);
    triangles += mixed.Triangles;
  }
  EXPECT_GT(triangles, 0);
}

TEST(Remesh, PureQuadsAreNeitherFoldedNorFlat)
{
  // Coarse maps of these have bad faces at features and in handles, the parts of which would be no better.
  RemeshOptions options;
  options.PureQuads = true;
  for (const auto& [surface, faces] :
    { std::pair<Surface, Index>(Meshes::ChamferedCube(4), 200), { Meshes::ChamferedCube(4), 800 },
      { Meshes::ChamferedCube(6), 200 }, { Meshes::DoubleTorus(), 200 } })
  {
    options.NumberOfFaces = faces;
    const RemeshResult mesh = Remesh(std::make_shared<Surface>(surface)).Compute(options);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Triangles, 0);
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.3) << faces;
  }
}

TEST(Remesh, PureQuadsAreAsRegularAsTheMeshWithTriangles)
{
  // Coarse meshes of many features and of noise.
  for (const auto& [surface, faces] :
    { std::pair<Surface, Index>(Meshes::PlateWithHole(48, 12, 0.6, true), 300),
      { Meshes::ChamferedCube(4), 200 }, { Meshes::DoubleTorus(), 300 },
      { Meshes::Jittered(Meshes::Potato(4), 0.04, 2), 300 } })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    Remesh remesh(std::make_shared<Surface>(surface));
    const RemeshResult mixed = remesh.Compute(options);
    options.PureQuads = true;
    const RemeshResult pure = remesh.Compute(options);
    EXPECT_EQ(Meshes::FlawOf(pure), "");
    EXPECT_EQ(pure.Triangles, 0);
    EXPECT_LE(pure.IrregularVertices, 1.1 * mixed.IrregularVertices + mixed.Triangles);
    EXPECT_NEAR(pure.Quads, mixed.Quads + mixed.Triangles, 0.1 * mixed.Quads);
    EXPECT_GT(Meshes::LeastQuality(pure), 0.2);
  }
}

TEST(Remesh, PureQuadsNeedNoSmoothing)
{
  RemeshOptions options;
  options.NumberOfFaces = 300;
  options.SmoothingIterations = 0;
  Remesh remesh(std::make_shared<Surface>(RoughCube(1)));
  const RemeshResult mixed = remesh.Compute(options);
  EXPECT_GT(mixed.Triangles, 0);
  options.PureQuads = true;
  const RemeshResult pure = remesh.Compute(options);
  EXPECT_EQ(Meshes::FlawOf(pure), "");
  EXPECT_EQ(pure.Triangles, 0);
  EXPECT_NEAR(pure.Quads, mixed.Quads + 0.5 * mixed.Triangles, 0.1 * mixed.Quads);
}
