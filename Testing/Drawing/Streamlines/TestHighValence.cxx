// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fans of many triangles around one point, as the caps that CAD programs write.

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Streamlines.h"
#include "Streamlines/LineSeeds.h"
#include "Streamlines/SingularPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace DirectionFields;
using Internal::FlatTriangle;
using Internal::SeedPlace;
using Internal::SingularPoints;
using Internal::ZeroBeside;

namespace
{
/// A cone of radius 1.
Surface Cone(int valence, double height)
{
  Surface cone;
  cone.Points.emplace_back(0.0, 0.0, height);
  for (int i = 0; i < valence; ++i)
  {
    const double angle = 2.0 * Pi * i / valence;
    cone.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    cone.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % valence });
  }
  return cone;
}

Vector3 Middle(const Surface& surface, const Triangle& triangle)
{
  return (surface.Points[triangle[0]] + surface.Points[triangle[1]] + surface.Points[triangle[2]]) /
    3.0;
}
}

TEST(HighValence, SingularitiesAreSeenWhereTheyAre)
{
  // The field of u = z - a: all triangles around the middle of the disk see its zero beside them.
  constexpr int valence = 2000;
  const Surface disk = Cone(valence, 0.0);
  const Complex a(0.002, 0.0007);
  const auto vector = [&](Index point)
  { return Complex(disk.Points[point].x(), disk.Points[point].y()) - a; };
  PointDirections directions;
  directions.Degree = 1;
  directions.Direction = [&](Index point, int)
  {
    const Complex u = vector(point) / std::abs(vector(point));
    return Vector3(u.real(), u.imag(), 0.0);
  };
  directions.Magnitude = [&](Index point) { return std::abs(vector(point)); };
  const GivenField field(disk, directions);
  const SingularPoints zeros(field);
  ASSERT_EQ(zeros.GetZeros().size(), 1U);
  const double unit = field.GetGeometry().Lengths.Unit[0];
  int seen = 0;
  for (Index t = 0; t < valence; ++t)
  {
    const auto [begin, end] = zeros.Beside(t);
    const Triangle& triangle = disk.Triangles[field.GetMesh().InputTriangle(t)];
    const Vector3 middle = Middle(disk, triangle);
    const double distance = std::hypot(middle.x() - a.real(), middle.y() - a.imag());
    const Complex place = FlatTriangle(field.GetGeometry(), t).Place({ 1 / 3., 1 / 3., 1 / 3. });
    for (const ZeroBeside* beside = begin; beside != end; ++beside)
    {
      EXPECT_NEAR(unit * std::abs(beside->Near(place) - place), distance, 1e-9);
    }
    if (begin != end)
    {
      // Both ways around the middle of a plane lead to the same place.
      EXPECT_NEAR(std::abs(begin->Seen[0] - begin->Seen[1]), 0.0, 1e-9);
      ++seen;
    }
  }
  EXPECT_EQ(seen, valence - 1);
}

TEST(HighValence, SeedsAreAsManyAsPointsAndArea)
{
  constexpr int valence = 4000;
  for (const double height : { 0.0, 1.0, 5.0 })
  {
    const Surface cone = Cone(valence, height);
    const Result result = Fields::Compute(cone, 4);
    const PointDirections directions = Fields::Of(result);
    const GivenField field(cone, directions);
    const double area = Pi * std::hypot(1.0, height);
    const double spacing = std::sqrt(area) / 40.0;
    const std::vector<SeedPlace> places = Internal::SeedPlaces(field, 0, spacing, {});
    EXPECT_LT(places.size(), valence + 3.0 * area / std::pow(spacing / 4.0, 2)) << height;
    // None of the surface is far from all of them.
    std::vector<Vector3> positions;
    for (const SeedPlace& place : places)
    {
      positions.push_back(
        field.InSpace(place.Triangle)
          .Position(FlatTriangle(field.GetGeometry(), place.Triangle).Weights(place.Place)));
    }
    for (int i = 0; i < 200; ++i)
    {
      const double radius = (i + 0.5) / 200.0;
      const Vector3 at(
        radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), height * (1.0 - radius));
      double nearest = 1e300;
      for (const Vector3& position : positions)
      {
        nearest = std::min(nearest, (position - at).norm());
      }
      EXPECT_LT(nearest, spacing) << height << " " << radius;
    }
  }
}

TEST(HighValence, SquaresOfTheSpacingAreThoseOfTheAreaHoweverNarrowTrianglesAre)
{
  const auto squares = [](const Surface& surface, double spacing, double most)
  {
    const Result result = Fields::Compute(surface, 4);
    const PointDirections directions = Fields::Of(result);
    const GivenField field(surface, directions);
    return Internal::FilledSquares(field, 0, spacing / field.GetGeometry().Lengths.Unit[0], most);
  };
  EXPECT_NEAR(squares(Meshes::Square(10), 0.05, 1e6), 400.0, 1e-6);
  for (const double height : { 0.0, 1.0, 50.0 })
  {
    const double area = Pi * std::hypot(1.0, height);
    const double spacing = std::sqrt(area) / 40.0;
    for (const int valence : { 90, 4000, 40000 })
    {
      // A grid in space has some cells more than a surface through it has squares.
      const double filled = squares(Cone(valence, height), spacing, 1e9);
      EXPECT_GT(filled, 0.5 * 1600.0) << height << " " << valence;
      EXPECT_LT(filled, 3.0 * 1600.0) << height << " " << valence;
    }
  }
  // It stops counting.
  EXPECT_LT(squares(Meshes::Square(100), 1e-4, 1000.0), 1e5);
}

TEST(HighValence, LinesOfSteepConesAreAsManyAsTheAreaHasRoomFor)
{
  constexpr double height = 50.0;
  const Surface cone = Cone(90, height);
  const Result result = Fields::Compute(cone, 16);
  const PointDirections directions = Fields::Of(result);
  const GivenField field(cone, directions);
  const Streamlines lines = TraceStreamlines(field, directions, {}, {});
  double length = 0.0;
  for (const double one : lines.Length)
  {
    length += one;
  }
  // Eight families, each of area / spacing. Lines end at half of the spacing from the next.
  const double room = 8.0 * Pi * std::hypot(1.0, height) / lines.Spacing;
  EXPECT_GT(length, 0.5 * room);
  EXPECT_LT(length, 2.0 * room);
  EXPECT_LT(lines.Points.size(), 200000U);
}
