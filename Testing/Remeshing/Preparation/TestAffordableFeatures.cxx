// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/AffordableFeatures.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

using namespace DirectionFields;
using Internal::AffordableFeatures;

namespace
{
constexpr double Faces = 2000.0;

AffordableFeatures AffordableFor(const Surface& surface, double angle)
{
  return { surface, { true, angle, 0.0, 0.0 }, 4, Faces };
}

RemeshResult MeshAt(const Surface& surface, double angle)
{
  RemeshOptions options;
  options.NumberOfFaces = static_cast<Index>(Faces);
  options.FeatureAngle = angle;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}
}

TEST(AffordableFeatures, AnAngleThatGivesFewIsTaken)
{
  for (const double angle : { 1.0, 5.0, 30.0, 60.0 })
  {
    const AffordableFeatures cube = AffordableFor(Meshes::Cube(), angle);
    EXPECT_EQ(cube.Settings.Angle, angle);
    EXPECT_TRUE(cube.Sentences().empty());
  }
}

TEST(AffordableFeatures, AnglesBetweenPlanesAndNothingAreTheSame)
{
  // With the edges within its sides each vertex would be a corner.
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 3);
  EXPECT_EQ(AffordableFor(cube, 0.0).Meeting, 8);
  const RemeshResult mesh = MeshAt(cube, 0.0);
  EXPECT_EQ(mesh.IrregularVertices, 8);
  EXPECT_EQ(mesh.Triangles, 0);
}

TEST(AffordableFeatures, OfTooManyTheSharpestAreKeptAndTheSentenceIsRight)
{
  const Surface sphere = Meshes::Icosphere(4);
  for (const double angle : { 0.0, 2.0 })
  {
    const AffordableFeatures features = AffordableFor(sphere, angle);
    EXPECT_GT(features.Meeting, 1000);
    EXPECT_GT(features.Settings.Angle, 2.0);
    EXPECT_LT(features.Settings.Angle, 30.0);
    EXPECT_EQ(features.Sentences().size(), 1u);
    EXPECT_TRUE(AffordableFor(sphere, features.Settings.Angle).Sentences().empty());
  }
  const RemeshResult mesh = MeshAt(sphere, 0.0);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  ASSERT_FALSE(mesh.Notes.empty());
  EXPECT_NE(mesh.Notes.back().find("Feature Angle of 0 "), std::string::npos);
  EXPECT_TRUE(MeshAt(sphere, 30.0).Notes.empty());
}

TEST(AffordableFeatures, NothingIsCountedWithoutFeaturesOrFaces)
{
  const Surface sphere = Meshes::Icosphere(3);
  EXPECT_EQ(AffordableFeatures(sphere, { false, 0.0, 0.0, 0.0 }, 4, Faces).Meeting, 0);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(AffordableFeatures(sphere, { true, 0.0, 0.0, 0.0 }, 4, infinite).Meeting, 0);
}
