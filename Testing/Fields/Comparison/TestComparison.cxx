// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Comparison/FieldDerivatives.h"
#include "Comparison/FieldDifference.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// A field with all its directions turned by an angle about the normals.
PointDirections Turned(const Result& result, double angle)
{
  PointDirections turned = Fields::Of(result);
  turned.Direction = [&result, angle](Index point, int k)
  {
    const Vector3 direction = result.Direction(point, k);
    return Vector3(
      std::cos(angle) * direction + std::sin(angle) * result.Normal[point].cross(direction));
  };
  return turned;
}

/// The n-th power of z - a over that of z - b on the unit disk and around it.
PointDirections PairField(
  const Surface& surface, int degree, const Complex& plus, const Complex& minus)
{
  return Fields::PlanarField(surface, degree,
    [=](const Vector3& p)
    {
      const Complex z(p.x(), p.y());
      return (std::arg(z - plus) - std::arg(z - minus)) / degree;
    });
}
}

TEST(Comparison, FieldsThatAreTurnedByAnAngleDifferByThat)
{
  const Surface surface = Potato(3);
  for (const int degree : { 1, 2, 4, 6 })
  {
    const Result result = Fields::Compute(surface, degree);
    const PointDirections given = Fields::Of(result);
    const GivenField field(surface, given);
    for (const double degrees : { 0.0, 3.0, 20.0, 59.0, 100.0 })
    {
      const double period = 360.0 / degree;
      const double expected = std::abs(std::remainder(degrees, period));
      const FieldDifference difference =
        Compare(field, given, Turned(result, degrees * Pi / 180.0));
      EXPECT_NEAR(difference.Mean, expected, 1e-9);
      EXPECT_NEAR(difference.Maximum, expected, 1e-6);
      for (const double angle : difference.Angle)
      {
        EXPECT_NEAR(angle, expected, 1e-6);
        EXPECT_LE(angle, 180.0 / degree + 1e-9);
      }
    }
  }
}

TEST(Comparison, MeansGoByAreaAndLeaveGhostsOut)
{
  Surface surface = Square(16);
  surface.Ghost.assign(surface.Triangles.size(), 0);
  const auto straight = [](const Vector3&) { return 0.0; };
  const PointDirections other =
    Fields::PlanarField(surface, 4, [](const Vector3& p) { return 0.6 * p.x(); });
  const PointDirections given = Fields::PlanarField(surface, 4, straight);
  {
    const GivenField field(surface, given);
    const FieldDifference difference = Compare(field, given, other);
    EXPECT_NEAR(difference.Mean, 0.3 * 180.0 / Pi, 1e-9);
    EXPECT_NEAR(difference.Maximum, 0.6 * 180.0 / Pi, 1e-9);
  }
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (const Index i : surface.Triangles[t])
    {
      surface.Ghost[t] = surface.Points[i].x() > 0.5 + 1e-9 ? 1 : surface.Ghost[t];
    }
  }
  const GivenField field(surface, given);
  const FieldDifference difference = Compare(field, given, other);
  EXPECT_NEAR(difference.Mean, 0.15 * 180.0 / Pi, 1e-9);
  EXPECT_NEAR(difference.Maximum, 0.3 * 180.0 / Pi, 1e-9);
}

TEST(Comparison, PointsWithoutDirectionsAreNoAgreement)
{
  const Surface surface = Square(4);
  const PointDirections one = Fields::PlanarField(surface, 2, [](const Vector3&) { return 0.0; });
  const GivenField field(surface, one);
  PointDirections other = Fields::PlanarField(surface, 2, [](const Vector3&) { return 0.5; });
  const auto given = other.Direction;
  other.Direction = [given](Index point, int k)
  { return point == 12 ? Vector3(Vector3::Zero()) : given(point, k); };
  const FieldDifference difference = Compare(field, one, other);
  EXPECT_TRUE(std::isnan(difference.Angle[12]));
  EXPECT_NEAR(difference.Mean, 0.5 * 180.0 / Pi, 1e-9);
}

TEST(Comparison, PointsOfOneVertexAreComparedByTheirOwnDirections)
{
  // The directions across the seams of a soup differ by less than what tells points apart.
  const Surface surface = Soup(Square(4));
  const auto nearly = [](double turned)
  {
    PointDirections directions;
    directions.Degree = 2;
    directions.Direction = [turned](Index point, int k)
    {
      const double angle = turned + 5e-6 * (point % 7) + Pi * k;
      return Vector3(std::cos(angle), std::sin(angle), 0.0);
    };
    directions.Magnitude = [](Index) { return 1.0; };
    return directions;
  };
  const PointDirections one = nearly(0.0), other = nearly(0.25);
  const GivenField field(surface, one);
  ASSERT_LT(field.GetMesh().GetNumberOfVertices(), static_cast<Index>(surface.Points.size()));
  EXPECT_LT(Compare(field, one, one).Maximum, 1e-12);
  const FieldDifference difference = Compare(field, one, other);
  for (const double angle : difference.Angle)
  {
    EXPECT_NEAR(angle, 0.25 * 180.0 / Pi, 1e-12);
  }
  EXPECT_EQ(difference.Angle, Compare(field, other, one).Angle);
}

TEST(Comparison, SingularitiesMatchThoseTheyWereMovedFrom)
{
  const Surface surface = Disk(40);
  for (const int degree : { 1, 2, 4 })
  {
    const GivenField one(surface, PairField(surface, degree, { 0.3, 0.2 }, { -0.4, -0.3 }));
    const GivenField other(surface, PairField(surface, degree, { 0.4, 0.1 }, { -0.35, -0.35 }));
    const std::vector<ComparedSingularity> list = MatchSingularities(one, other);
    ASSERT_EQ(list.size(), 4U);
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      EXPECT_EQ(list[i].Field, i < 2 ? 0 : 1);
      ASSERT_NE(list[i].Match, None);
      const ComparedSingularity& match = list[static_cast<std::size_t>(list[i].Match)];
      EXPECT_EQ(match.Match, static_cast<Index>(i));
      EXPECT_NE(match.Field, list[i].Field);
      EXPECT_EQ(match.SingularityIndex, list[i].SingularityIndex);
      const double expected =
        list[i].SingularityIndex > 0 ? std::hypot(0.1, 0.1) : std::hypot(0.05, 0.05);
      EXPECT_NEAR(list[i].Distance, expected, 0.01);
      EXPECT_NEAR((match.Position - list[i].Position).norm(), expected, 0.01);
    }
  }
}

TEST(Comparison, AFieldMatchesItself)
{
  for (const Surface& surface : { Potato(3), Torus(24, 12), Joined(Potato(2), Icosphere(2)) })
  {
    const Result result = Fields::Compute(surface, 4);
    const GivenField field(surface, Fields::Of(result));
    const std::vector<ComparedSingularity> list = MatchSingularities(field, field);
    for (const ComparedSingularity& singularity : list)
    {
      ASSERT_NE(singularity.Match, None);
      EXPECT_EQ(list[static_cast<std::size_t>(singularity.Match)].Triangle, singularity.Triangle);
      EXPECT_EQ(singularity.Distance, 0.0);
    }
  }
}

TEST(Comparison, AnySurfaceAgreesWithItself)
{
  Surface broken = Potato(1);
  broken.Points[5].x() = std::nan("");
  broken.Triangles[3] = { 1, 1, 2 };
  Surface fins;
  fins.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 1, 0 }, { 0.3, -1, 0 }, { 0.3, 0, 1 } };
  fins.Triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 } };
  Surface ghosts = Potato(2);
  ghosts.Ghost.assign(ghosts.Triangles.size(), 1);
  for (const Surface& surface : { MoebiusStrip(30, 3), KleinBottle(20, 12), BadSphere(2, 0.6, 1),
         Soup(Potato(1)), broken, fins, ghosts, Surface() })
  {
    for (const int degree : { 1, 2, 4 })
    {
      PointDirections directions;
      directions.Degree = degree;
      directions.Direction = [degree](Index point, int k)
      {
        const double angle = 0.3 * point + 2.0 * Pi * k / degree;
        return Vector3(std::cos(angle), std::sin(angle), 0.1 * (point % 7)).normalized();
      };
      directions.Magnitude = [](Index point) { return 1.0 + point % 3; };
      const GivenField field(surface, directions);
      const FieldDifference difference = Compare(field, directions, directions);
      for (const double angle : difference.Angle)
      {
        EXPECT_FALSE(angle > 1e-9) << angle;
      }
      EXPECT_FALSE(difference.Mean > 1e-9) << difference.Mean;
      const std::vector<ComparedSingularity> list = MatchSingularities(field, field);
      for (const ComparedSingularity& singularity : list)
      {
        EXPECT_NE(singularity.Match, None);
        EXPECT_EQ(singularity.Distance, 0.0);
      }
    }
  }
}

TEST(Comparison, WhatHasNoPartnerStaysAlone)
{
  const Surface surface = Disk(30);
  const GivenField one(surface, PairField(surface, 4, { 0.3, 0.2 }, { -5.0, 0.0 }));
  const GivenField other(surface, PairField(surface, 4, { -0.3, 0.2 }, { 0.1, -0.5 }));
  const std::vector<ComparedSingularity> list = MatchSingularities(one, other);
  ASSERT_EQ(list.size(), 3U);
  int alone = 0;
  for (const ComparedSingularity& singularity : list)
  {
    alone += singularity.Match == None ? 1 : 0;
    EXPECT_EQ(std::isnan(singularity.Distance), singularity.Match == None);
    EXPECT_EQ(singularity.SingularityIndex < 0, singularity.Match == None);
  }
  EXPECT_EQ(alone, 1);
}

TEST(Comparison, DivergenceAndCurlOfKnownFields)
{
  // Away from the center a vector to the outside has the divergence 1 / r, one around it the curl 1 / r.
  std::vector<double> errors;
  for (const int rings : { 20, 40, 80 })
  {
    const Surface surface = Disk(rings);
    double worst = 0.0;
    for (const int degree : { 1, 2 })
    {
      for (const bool isAround : { false, true })
      {
        const GivenField field(surface,
          Fields::PlanarField(surface, degree,
            [=](const Vector3& p)
            { return std::atan2(p.y(), p.x()) + (isAround ? 0.5 * Pi : 0.0); }));
        const FieldDerivatives derivatives(field);
        for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
        {
          const Triangle& corners = surface.Triangles[t];
          const Vector3 middle =
            (surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]]) /
            3.0;
          if (middle.norm() > 0.3)
          {
            const double around = isAround ? derivatives.Curl[t] : derivatives.Divergence[t];
            const double none = isAround ? derivatives.Divergence[t] : derivatives.Curl[t];
            worst = std::max({ worst, std::abs(around - 1.0 / middle.norm()), std::abs(none) });
          }
        }
      }
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors[1], 0.6 * errors[0]);
  EXPECT_LT(errors[2], 0.6 * errors[1]);
  EXPECT_LT(errors[2], 0.1);
}

TEST(Comparison, DivergenceOnASphereIsThatOfTheGradient)
{
  // X = the unit vector to the pole: its divergence is -cot of the distance from the pole, which needs the cones' angles.
  const Surface surface = Icosphere(5);
  PointDirections given;
  given.Degree = 1;
  given.Direction = [&](Index point, int)
  {
    const Vector3& p = surface.Points[point];
    return Vector3((Vector3::UnitZ() - p.z() * p).stableNormalized());
  };
  given.Magnitude = [](Index) { return 1.0; };
  const GivenField field(surface, given);
  const FieldDerivatives derivatives(field);
  double mean = 0.0;
  int count = 0;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    const Vector3 middle =
      (surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]])
        .normalized();
    if (std::abs(middle.z()) < 0.8)
    {
      const double expected = -middle.z() / std::sqrt(1.0 - middle.z() * middle.z());
      mean += std::abs(derivatives.Divergence[t] - expected) + std::abs(derivatives.Curl[t]);
      ++count;
    }
  }
  EXPECT_LT(mean / count, 0.03);
}

TEST(Comparison, DerivativesAreForVectorsAndLines)
{
  const Surface surface = Square(4);
  const GivenField cross(
    surface, Fields::PlanarField(surface, 4, [](const Vector3&) { return 0.0; }));
  EXPECT_THROW(FieldDerivatives derivatives(cross), std::invalid_argument);
  // A line field with a trisector has no vectors in one triangle.
  const Surface disk = Disk(9);
  const GivenField lines(disk,
    Fields::PlanarField(
      disk, 2, [](const Vector3& p) { return -0.5 * std::atan2(p.y() - 0.02, p.x() - 0.03); }));
  const FieldDerivatives derivatives(lines);
  EXPECT_EQ(std::count_if(derivatives.Curl.begin(), derivatives.Curl.end(),
              [](double curl) { return std::isnan(curl); }),
    1);
}
