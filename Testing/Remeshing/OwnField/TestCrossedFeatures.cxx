// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Guidance/Guidance.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "OwnField/CrossedFeatures.h"
#include "Preparation/PreparedField.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// The same direction at all points of a square, at this angle to its sides.
std::vector<Vector3> Straight(const Surface& square, double degrees)
{
  const double angle = degrees / 180.0 * Pi;
  return { square.Points.size(), Vector3(std::cos(angle), std::sin(angle), 0.0) };
}

/// A closed cylinder of few sides, as ParaView's source Cylinder makes it.
Surface ClosedCylinder(int sides)
{
  Surface surface;
  for (int k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * Pi * k / sides;
    const Vector3 around(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0);
    surface.Points.push_back(around - 0.5 * Vector3::UnitZ());
    surface.Points.push_back(around + 0.5 * Vector3::UnitZ());
  }
  for (Index k = 0; k < sides; ++k)
  {
    const Index next = (k + 1) % sides;
    surface.Triangles.push_back({ 2 * k, 2 * next, 2 * k + 1 });
    surface.Triangles.push_back({ 2 * next, 2 * next + 1, 2 * k + 1 });
    if (k >= 2)
    {
      surface.Triangles.push_back({ 0, 2 * k, 2 * k - 2 });
      surface.Triangles.push_back({ 1, 2 * k - 1, 2 * k + 1 });
    }
  }
  return surface;
}

PreparedField Prepared(const Surface& surface, const std::vector<Vector3>& directions, double face)
{
  WorkingLengths lengths;
  lengths.Face = face;
  return { surface, 4, KeptEdges({ true, 40.0, 0.0, 0.0 }), lengths, directions,
    OwnShape(ShapeAlignment{}), Progress() };
}
}

TEST(CrossedFeatures, ThePartIsThatOfTheBoundaryMoreThan15DegreesOff)
{
  const Surface square = Meshes::Square(8);
  const SurfaceGeometry geometry(square);
  for (const double degrees : { 0.0, 14.0, 16.0, 45.0, 74.0, 76.0, 90.0 })
  {
    Guidance guidance;
    guidance.Vectors = Straight(square, degrees);
    const CrossedFeatures crossed(geometry, 4,
      std::vector<char>(geometry.Mesh.GetNumberOfEdges(), 0),
      GuidanceSection(geometry, guidance, 4));
    const bool isAlong = degrees < 15.0 || degrees > 75.0;
    EXPECT_NEAR(crossed.GetPart(), isAlong ? 0.0 : 1.0, 1e-12) << degrees;
  }
}

TEST(CrossedFeatures, FieldsTurnNearThemAndStayElsewhere)
{
  const Surface square = Meshes::Square(40);
  const double face = 0.05;
  const std::vector<Vector3> given = Straight(square, 30.0);
  const PreparedField field = Prepared(square, given, face);
  EXPECT_NEAR(field.GetPartCrossed(), 1.0, 1e-12);
  const SurfaceGeometry& geometry = field.GetGeometry();
  int stay = 0;
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3& p = geometry.Positions[v];
    const double inside = std::min({ p[0], 1.0 - p[0], p[1], 1.0 - p[1] });
    const Complex along = geometry.Frames.Tangential(v, Vector3::UnitX());
    const double turned =
      std::arg(field.GetSection()[v] * std::polar(1.0, -4.0 * std::arg(along))) / 4.0;
    if (inside > 4.0 * face)
    {
      ++stay;
      EXPECT_NEAR(turned, Pi / 6.0, 1e-9);
    }
    else if (inside < 1e-9)
    {
      EXPECT_NEAR(turned, 0.0, 1e-9);
    }
  }
  EXPECT_GT(stay, 100);
}

TEST(CrossedFeatures, FieldsThatFollowThemAreAsGiven)
{
  const Surface square = Meshes::Square(20);
  const PreparedField field = Prepared(square, Straight(square, 5.0), 0.05);
  EXPECT_EQ(field.GetPartCrossed(), 0.0);
  const SurfaceGeometry& geometry = field.GetGeometry();
  Guidance guidance;
  guidance.Vectors = Straight(square, 5.0);
  EXPECT_EQ(field.GetSection(), GuidanceSection(geometry, guidance, 4));
}

TEST(CrossedFeatures, QuadsOfASmoothFieldFollowTheEdgesOfParts)
{
  // The smoothest field of a part knows nothing of its edges, and its triangles are long.
  for (const int sides : { 6, 30 })
  {
    const auto part = std::make_shared<Surface>(ClosedCylinder(sides));
    const Result smoothest = DirectionField(part).Compute(Options());
    std::vector<Vector3> directions;
    for (Index p = 0; p < static_cast<Index>(part->Points.size()); ++p)
    {
      directions.push_back(smoothest.Direction(p, 0));
    }
    RemeshOptions options;
    options.NumberOfFaces = 3000;
    const RemeshResult mesh = Remesh(part).Compute(options, directions);
    EXPECT_EQ(Meshes::FlawOf(mesh), "") << sides;
    EXPECT_LE(100 * mesh.Triangles, static_cast<Index>(mesh.Faces.size())) << sides;
    EXPECT_LE(mesh.IrregularVertices, 16) << sides;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.6) << sides;
  }
}
