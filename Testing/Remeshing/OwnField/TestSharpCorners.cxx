// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "OwnField/SharpCorners.h"
#include "Preparation/PreparedField.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
double Radians(double degrees)
{
  return degrees / 180.0 * Pi;
}

/// A triangle with two sides of length 1 at this angle, in radians.
Surface Wedge(double angle)
{
  Surface surface;
  surface.Points = { Vector3::Zero(), Vector3(std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0),
    Vector3(std::cos(0.5 * angle), -std::sin(0.5 * angle), 0.0) };
  surface.Triangles = { { 0, 2, 1 } };
  return surface;
}

/// A cone of height 1 over a polygon of radius 0.5, as ParaView's source Cone makes it.
Surface Cone(int sides)
{
  Surface surface;
  surface.Points.emplace_back(0.5, 0.0, 0.0);
  for (int k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * Pi * k / sides;
    surface.Points.emplace_back(-0.5, 0.5 * std::cos(angle), 0.5 * std::sin(angle));
  }
  for (int k = 0; k < sides; ++k)
  {
    surface.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % sides });
    if (k >= 2)
    {
      surface.Triangles.push_back({ 1, 1 + k, k });
    }
  }
  return surface;
}

double AreaOf(const Surface& surface)
{
  double area = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3& p = surface.Points[t[0]];
    area += 0.5 * (surface.Points[t[1]] - p).cross(surface.Points[t[2]] - p).norm();
  }
  return area;
}

double AreaOf(const RemeshResult& mesh)
{
  double area = 0.0;
  for (const std::array<Index, 4>& f : mesh.Faces)
  {
    const Vector3& p = mesh.Points[f[0]];
    const Vector3 diagonal = mesh.Points[f[2]] - p;
    area += 0.5 * (mesh.Points[f[1]] - p).cross(diagonal).norm();
    area += f[3] == None ? 0.0 : 0.5 * diagonal.cross(mesh.Points[f[3]] - p).norm();
  }
  return area;
}

RemeshResult Remeshed(
  const Surface& surface, Index faces, const std::vector<Vector3>& directions = {})
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options, directions);
}

double DistanceTo(const RemeshResult& mesh, const Vector3& place)
{
  double least = (mesh.Points.front() - place).norm();
  for (const Vector3& point : mesh.Points)
  {
    least = std::min(least, (point - place).norm());
  }
  return least;
}
}

TEST(SharpCorners, PlatesHaveFacesAsGoodAsTheirCorners)
{
  // A face at a corner has its angle, so that no scaled Jacobian is above its sine.
  for (const double degrees : { 15.0, 20.0, 26.0, 40.0 })
  {
    const Surface wedge = Wedge(Radians(degrees));
    for (const Index faces : { 300, 1000 })
    {
      const RemeshResult mesh = Remeshed(wedge, faces);
      EXPECT_EQ(Meshes::FlawOf(mesh), "") << degrees << ' ' << faces;
      EXPECT_LE(100 * mesh.Triangles, static_cast<Index>(mesh.Faces.size()))
        << degrees << ' ' << faces;
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.9 * std::sin(Radians(degrees)))
        << degrees << ' ' << faces;
      EXPECT_NEAR(AreaOf(mesh), AreaOf(wedge), 1e-9) << degrees << ' ' << faces;
      for (const Vector3& corner : wedge.Points)
      {
        EXPECT_LT(DistanceTo(mesh, corner), 1e-9) << degrees << ' ' << faces;
      }
    }
  }
}

TEST(SharpCorners, ConesOfFewSidesKeepTheirEdgesAndApex)
{
  for (const int sides : { 4, 6, 8 })
  {
    const Surface cone = Cone(sides);
    const double corner = 2.0 * std::asin(0.5 * std::sin(Pi / sides) / std::sqrt(1.25));
    for (const Index faces : { 300, 1000 })
    {
      const RemeshResult mesh = Remeshed(cone, faces);
      EXPECT_EQ(Meshes::FlawOf(mesh), "") << sides << ' ' << faces;
      EXPECT_LE(100 * mesh.Triangles, static_cast<Index>(mesh.Faces.size()))
        << sides << ' ' << faces;
      EXPECT_GT(Meshes::LeastQuality(mesh), 0.8 * std::sin(corner)) << sides << ' ' << faces;
      EXPECT_NEAR(AreaOf(mesh), AreaOf(cone), 1e-6) << sides << ' ' << faces;
      EXPECT_LT(DistanceTo(mesh, cone.Points[0]), 1e-9) << sides << ' ' << faces;
    }
  }
}

TEST(SharpCorners, TrianglesHaveThemBelow30Degrees)
{
  // A triangle at a corner has its angle, too; the scaled Jacobian of a regular one counts as 1.
  const double degrees = 26.0;
  RemeshOptions options;
  options.Element = Element::Triangles;
  options.NumberOfFaces = 1000;
  const Surface wedge = Wedge(Radians(degrees));
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(wedge)).Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 1000.0, 100.0);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.9 * std::sin(Radians(degrees)) / std::sin(Pi / 3.0));
  EXPECT_NEAR(AreaOf(mesh), AreaOf(wedge), 1e-9);
}

TEST(SharpCorners, HaveOneSingularityEach)
{
  // The boundary turns by four right angles, and by one less at each corner that is a face's: the
  // field makes up for the fourth.
  WorkingLengths lengths;
  lengths.Face = 0.03;
  const PreparedField field(Meshes::FlatlySubdivided(Wedge(Radians(26.0)), 5), 4,
    KeptEdges({ true, 40.0, 0.0, 0.0 }), lengths, {}, OwnShape(ShapeAlignment{}), Progress());
  const SurfaceGeometry& geometry = field.GetGeometry();
  const FieldMatching& matching = field.GetMatching();
  EXPECT_EQ(std::count(field.GetCorners().begin(), field.GetCorners().end(), 1), 1);
  Index found = 0;
  for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); ++t)
  {
    if (matching.SingularityIndex[t] != 0)
    {
      ++found;
      EXPECT_EQ(matching.SingularityIndex[t], 1);
      EXPECT_LT(geometry.Positions[geometry.Mesh.Tail(3 * t)].norm(), 0.3);
    }
  }
  EXPECT_EQ(found, 1);
}

TEST(SharpCorners, AreNotFoundWhereSidesAreShortOrBlunt)
{
  const auto count = [](const Surface& surface, double face)
  {
    const SurfaceGeometry geometry(surface);
    const std::vector<char> none(geometry.Mesh.GetNumberOfEdges(), 0);
    const SharpCorners corners(geometry, 4, none, face);
    return std::count_if(corners.Directions.begin(), corners.Directions.end(),
      [](const Vector3& direction) { return !direction.isZero(0.0); });
  };
  const auto wedge = [](double degrees)
  { return Meshes::FlatlySubdivided(Wedge(Radians(degrees)), 5); };
  // Halfway between one face and none it must not depend on rounding.
  EXPECT_GT(count(wedge(44.0), 0.03), 0);
  EXPECT_GT(count(wedge(45.0), 0.03), 0);
  EXPECT_GT(count(wedge(46.0), 0.03), 0);
  EXPECT_EQ(count(wedge(55.0), 0.03), 0);
  EXPECT_EQ(count(wedge(2.0), 0.03), 0);
  EXPECT_EQ(count(wedge(26.0), 0.5), 0);
  EXPECT_EQ(count(Meshes::Square(8), 0.03), 0);
}

TEST(SharpCorners, FieldsThatAreGivenTurnThere)
{
  // Straight lines are the smoothest field of a plate, and cross two of its sides.
  const Surface wedge = Meshes::FlatlySubdivided(Wedge(Radians(26.0)), 5);
  const RemeshResult mesh =
    Remeshed(wedge, 1000, std::vector<Vector3>(wedge.Points.size(), Vector3::UnitX()));
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_LE(100 * mesh.Triangles, static_cast<Index>(mesh.Faces.size()));
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.5 * std::sin(Radians(26.0)));
  EXPECT_NEAR(AreaOf(mesh), AreaOf(wedge), 1e-9);
}
