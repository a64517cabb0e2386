// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/FieldInterpolation.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;
using namespace Fields;

namespace
{
/// The same directions, numbered differently at each point.
PointDirections Renumbered(const PointDirections& field)
{
  PointDirections other = field;
  other.Direction = [field](Index point, int k)
  { return field.Direction(point, (k + 7 * point) % field.Degree); };
  return other;
}

/// Largest angle from a direction of one to the nearest of the other.
double Deviation(const DirectionsAt& one, const DirectionsAt& other, int degree)
{
  double nearest = Pi;
  for (int k = 0; k < degree; ++k)
  {
    const Vector3 d = other.Turned(k, degree);
    nearest = std::min(nearest, std::atan2(one.Direction.cross(d).norm(), one.Direction.dot(d)));
  }
  return nearest;
}
}

TEST(FieldInterpolation, BlendsPowersOnThePlane)
{
  const Surface surface = Meshes::Square(3);
  const SurfaceIncidence incidence(surface);
  for (const int n : { 1, 2, 3, 4, 6, 7 })
  {
    // So slow that the n-th powers never cancel.
    const auto angle = [n](const Vector3& p) { return (1.1 * p.x() - 0.7 * p.y() + 0.4) / n; };
    const PointDirections field = PlanarField(surface, n, angle);
    const GivenField given(surface, field);
    const FieldInterpolation interpolation(incidence, given, field);
    for (Index t = 0; t < incidence.GetNumberOfTriangles(); ++t)
    {
      for (const std::array<double, 3>& weights : std::vector<std::array<double, 3>>{
             { 1, 0, 0 }, { 0, 0, 1 }, { 0.5, 0.5, 0 }, { 0.2, 0.3, 0.5 } })
      {
        const DirectionsAt at = interpolation.At({ t, weights });
        Complex u = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          u += weights[c] * std::polar(1.0, n * angle(incidence.Corner(t, c)));
        }
        EXPECT_NEAR(at.Magnitude, std::abs(u), 1e-12);
        EXPECT_LT((at.Normal - Vector3::UnitZ()).norm(), 1e-12);
        for (int k = 0; k < n; ++k)
        {
          const Vector3 d = at.Turned(k, n);
          const Complex power = std::polar(1.0, n * std::atan2(d.y(), d.x()));
          EXPECT_NEAR(std::abs(power - u / std::abs(u)), 0.0, 1e-11);
        }
      }
    }
  }
}

TEST(FieldInterpolation, EqualsTheFieldAtPoints)
{
  const Surface surface = Meshes::Potato(2);
  const SurfaceIncidence incidence(surface);
  for (const int n : { 1, 2, 4, 6 })
  {
    const Result result = Compute(surface, n);
    const PointDirections field = Of(result);
    const GivenField given(surface, field);
    const FieldInterpolation interpolation(incidence, given, field);
    for (Index i = 0; i < incidence.GetNumberOfPoints(); ++i)
    {
      const DirectionsAt at = interpolation.AtPoint(i);
      EXPECT_EQ(at.Point, i);
      EXPECT_LT((at.Normal - result.Normal[i]).norm(), 1e-9);
      for (int k = 0; k < n; ++k)
      {
        EXPECT_LT((at.Turned(k, n) - result.Direction(i, k)).norm(), 1e-9);
      }
      // In a triangle it is laid into its plane, with the same numbers: nearly the same.
      const Index t = *incidence.BeginTriangles(i);
      SurfacePoint corner{ t, { 0, 0, 0 } };
      corner.Weights[incidence.FindCorner(t, i)] = 1.0;
      const DirectionsAt flat = interpolation.At(corner);
      EXPECT_EQ(flat.Point, i);
      EXPECT_NEAR(flat.Magnitude, field.Magnitude(i), 1e-12);
      EXPECT_LT((flat.Normal - incidence.Normal(t)).norm(), 1e-12);
      EXPECT_NEAR(flat.Direction.dot(flat.Normal), 0.0, 1e-12);
      EXPECT_GT(flat.Direction.dot(at.Direction), 0.9);
    }
  }
}

TEST(FieldInterpolation, DoesNotDependOnTheFirstDirection)
{
  const Surface surface = Meshes::Potato(2);
  const SurfaceIncidence incidence(surface);
  for (const int n : { 2, 4, 6 })
  {
    const Result result = Compute(surface, n);
    const PointDirections field = Of(result);
    const PointDirections other = Renumbered(field);
    const GivenField givenOne(surface, field), givenTwo(surface, other);
    const FieldInterpolation one(incidence, givenOne, field), two(incidence, givenTwo, other);
    for (Index t = 0; t < incidence.GetNumberOfTriangles(); ++t)
    {
      const SurfacePoint place{ t, { 0.3, 0.45, 0.25 } };
      EXPECT_LT(Deviation(one.At(place), two.At(place), n), 1e-9);
      EXPECT_NEAR(one.At(place).Magnitude, two.At(place).Magnitude, 1e-12);
    }
  }
}

TEST(FieldInterpolation, TurnsWithTheSurface)
{
  const Surface surface = Meshes::Potato(2);
  const Eigen::Matrix3d rotation = Meshes::ObliqueRotation(1.3);
  const Surface turned = Meshes::Transformed(surface, rotation, { 1, 2, 3 });
  const SurfaceIncidence incidence(surface), turnedIncidence(turned);
  const Result result = Compute(surface, 4);
  const PointDirections field = Of(result);
  PointDirections turnedField = field;
  turnedField.Direction = [&](Index point, int k)
  { return Vector3(rotation * result.Direction(point, k)); };
  const GivenField given(surface, field), turnedGiven(turned, turnedField);
  const FieldInterpolation one(incidence, given, field),
    two(turnedIncidence, turnedGiven, turnedField);
  for (Index t = 0; t < incidence.GetNumberOfTriangles(); ++t)
  {
    const SurfacePoint place{ t, { 0.1, 0.3, 0.6 } };
    const DirectionsAt a = one.At(place), b = two.At(place);
    EXPECT_LT((rotation * a.Direction - b.Direction).norm(), 1e-9);
    EXPECT_EQ(a.Point, b.Point);
  }
}

TEST(FieldInterpolation, IsContinuousAcrossEdges)
{
  // On an edge, the directions are the same against it in both triangles.
  const Surface surface = Meshes::Potato(3);
  const SurfaceIncidence incidence(surface);
  const Result result = Compute(surface, 4);
  const PointDirections field = Of(result);
  const GivenField given(surface, field);
  const FieldInterpolation interpolation(incidence, given, field);
  for (Index t = 0; t < incidence.GetNumberOfTriangles(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index other = incidence.Across(t, c);
      ASSERT_NE(other, None);
      const Index a = surface.Triangles[t][c], b = surface.Triangles[t][(c + 1) % 3];
      SurfacePoint here{ t, { 0, 0, 0 } }, there{ other, { 0, 0, 0 } };
      here.Weights[c] = there.Weights[incidence.FindCorner(other, a)] = 0.4;
      here.Weights[(c + 1) % 3] = there.Weights[incidence.FindCorner(other, b)] = 0.6;
      const DirectionsAt one = interpolation.At(here), two = interpolation.At(there);
      const Vector3 edge = (surface.Points[b] - surface.Points[a]).normalized();
      const auto power = [&](const DirectionsAt& at)
      {
        const Complex along(at.Direction.dot(edge), at.Direction.dot(at.Normal.cross(edge)));
        return along * along * along * along;
      };
      EXPECT_LT(std::abs(power(one) - power(two)), 1e-11);
      EXPECT_NEAR(one.Magnitude, two.Magnitude, 1e-12);
    }
  }
}

TEST(FieldInterpolation, LeavesOutWhatIsNotThere)
{
  const Surface surface = Meshes::Square(1);
  const SurfaceIncidence incidence(surface);
  const auto right = [](const Vector3&) { return 0.3; };
  PointDirections field = PlanarField(surface, 4, right);
  const auto direction = field.Direction;
  const Index missing = surface.Triangles[0][0];
  for (const Vector3& bad :
    { Vector3(0, 0, 0), Vector3(std::nan(""), 0, 0), Vector3(INFINITY, 0, 0) })
  {
    field.Direction = [&](Index point, int k)
    { return point == missing ? bad : direction(point, k); };
    const GivenField given(surface, field);
    const FieldInterpolation interpolation(incidence, given, field);
    const DirectionsAt at = interpolation.At({ 0, { 0.5, 0.25, 0.25 } });
    EXPECT_NEAR(at.Magnitude, 0.5, 1e-12);
    EXPECT_LT(Deviation(at, interpolation.At({ 0, { 0, 1, 0 } }), 4), 1e-9);
    EXPECT_EQ(interpolation.At({ 0, { 1, 0, 0 } }).Magnitude, 0.0);
    EXPECT_EQ(interpolation.AtPoint(missing).Magnitude, 0.0);
  }
  field.Direction = direction;
  field.Magnitude = [missing](Index point) { return point == missing ? std::nan("") : 1.0; };
  const GivenField given(surface, field);
  const FieldInterpolation interpolation(incidence, given, field);
  EXPECT_NEAR(interpolation.At({ 0, { 0.5, 0.25, 0.25 } }).Magnitude, 0.5, 1e-12);
}
