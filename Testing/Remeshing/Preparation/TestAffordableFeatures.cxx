// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/AffordableFeatures.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

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

namespace
{
Internal::AccidentalFeatures AccidentalOf(const Surface& surface)
{
  return { SurfaceGeometry(surface), 40.0 };
}
}

TEST(AccidentalFeatures, ThoseOfAShapeAreNone)
{
  EXPECT_FALSE(AccidentalOf(Meshes::Cube()).IsAny);
  // All of its edges are sharp by 45 degrees.
  EXPECT_FALSE(AccidentalOf(Meshes::ChamferedCube(6)).IsAny);
}

TEST(AccidentalFeatures, StretchedTrianglesHaveThem)
{
  EXPECT_TRUE(AccidentalOf(Meshes::BallWithLimbs()).IsAny);
}

TEST(AccidentalFeatures, AreLeftOutWhereFacesAlongThemAreBad)
{
  RemeshOptions options;
  options.NumberOfFaces = 3000;
  const RemeshResult mesh =
    Remesh(std::make_shared<Surface>(Meshes::BallWithLimbs())).Compute(options);
  EXPECT_EQ(mesh.TurnedFaces, 0);
  EXPECT_LE(mesh.Triangles, 30);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.3);
  EXPECT_LT(std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh), mesh.EdgeLength);
  EXPECT_TRUE(std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
    [](const std::string& note)
    { return note.find("No edges are features") != std::string::npos; }));
}

namespace
{
/// A ball with limbs whose width is a part of the usual one.
RemeshResult MeshOfThinLimbs(double part, Index faces, bool keepsThinParts = true)
{
  Surface thin = Meshes::BallWithLimbs();
  for (Vector3& point : thin.Points)
  {
    Index along = 0;
    const double far = point.cwiseAbs().maxCoeff(&along);
    const double narrower = 1.0 - (1.0 - part) * std::clamp((far - 1.1) / 0.3, 0.0, 1.0);
    const double kept = point[along];
    point *= narrower;
    point[along] = kept;
  }
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.KeepThinParts = keepsThinParts;
  return Remesh(std::make_shared<Surface>(thin)).Compute(options);
}
}

TEST(AccidentalFeatures, ThinPartsComeBackBeforeAMeshWithoutThemIsJudged)
{
  // The limbs are lost at first, and kept by smaller faces then.
  const RemeshResult mesh = MeshOfThinLimbs(0.25, 3000);
  EXPECT_LE(mesh.Triangles + mesh.TurnedFaces, 30);
  EXPECT_LT(std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh), mesh.EdgeLength);
}

TEST(AccidentalFeatures, AreToldByThoseThatAreTooShortToBeKeptAsWell)
{
  // Of this few faces only long features are kept, which have not all of the angles.
  const RemeshResult mesh = MeshOfThinLimbs(0.4, 700);
  EXPECT_LE(mesh.Triangles + mesh.TurnedFaces, 10);
  EXPECT_LT(std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh), mesh.EdgeLength);
}

TEST(AccidentalFeatures, AreLeftOutOfMeshesThatAreBadWithoutThemAndWorseWithThem)
{
  // Too few faces for the limbs: neither mesh is good.
  const RemeshResult mesh = MeshOfThinLimbs(0.5, 700, false);
  EXPECT_GT(mesh.Triangles + mesh.TurnedFaces, 7);
  EXPECT_TRUE(std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
    [](const std::string& note)
    { return note.find("No edges are features") != std::string::npos; }));
}
