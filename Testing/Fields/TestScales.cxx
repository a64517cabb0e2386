// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sizes and places of surfaces, and how many components they have.

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Result ComputeExactly(const Surface& surface)
{
  return Fields::Compute(surface, 4, 0.0, 1e-10);
}

/// The surface scaled by a size and moved by that times a distance, in coordinates of the type.
template <typename Real>
Surface Placed(const Surface& surface, double size, double distance)
{
  Surface placed = surface;
  for (Vector3& p : placed.Points)
  {
    p = (size * (p + distance * Vector3(0.6, -0.64, 0.48))).cast<Real>().template cast<double>();
  }
  return placed;
}

/// The largest angle between directions of two fields of the same surface, degrees, where the field is
/// clear.
double LargestDeviation(const Result& one, const Result& other)
{
  double largest = 0.0;
  for (Index i = 0; i < static_cast<Index>(one.Representation.size()); ++i)
  {
    if (std::abs(one.Representation[i]) > 0.3)
    {
      largest = std::max(largest, Deviation(other, i, one.Direction(i, 0)));
    }
  }
  return largest;
}

/// By how much rounding turns the directions, degrees: its step over the length of an edge.
double RoundingAngle(const Surface& surface, double distance, double epsilon)
{
  double sum = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    sum += (surface.Points[t[1]] - surface.Points[t[0]]).norm();
  }
  const double edge = sum / static_cast<double>(surface.Triangles.size());
  return 180.0 / Pi * epsilon * std::max(1.0, distance) / edge;
}
}

TEST(Scales, AccuracyIsThatOfTheCoordinates)
{
  const Surface surface = Potato(3);
  const Result exact = ComputeExactly(surface);
  for (const double size : { 1e-9, 1e-3, 1.0, 1e9 })
  {
    for (const double distance : { 0.0, 1e2, 1e4, 1e5, 1e6, 1e8 })
    {
      const auto check = [&](const Result& result, double epsilon)
      {
        SCOPED_TRACE("size " + std::to_string(size) + " distance " + std::to_string(distance));
        EXPECT_TRUE(result.Components[0].Converged);
        EXPECT_EQ(result.Components[0].IndexSum, 8);
        const double angle = RoundingAngle(surface, distance, epsilon);
        // The rounding of coordinates, and that of a good thousand unknowns.
        if (angle < 10.0)
        {
          EXPECT_LT(LargestDeviation(exact, result), 4.0 * angle + 1e-9);
          EXPECT_NEAR(
            result.Components[0].Eigenvalue * size * size / exact.Components[0].Eigenvalue, 1.0,
            std::pow(angle * Pi / 180.0, 2) + 0.1 * angle * Pi / 180.0 + 1e-12);
        }
      };
      check(ComputeExactly(Placed<float>(surface, size, distance)), std::ldexp(1.0, -24));
      check(ComputeExactly(Placed<double>(surface, size, distance)), std::ldexp(1.0, -53));
    }
  }
}

TEST(Scales, CoordinatesThatHaveLostTheShapeStillGiveAField)
{
  // A million times its size away a surface of floats is a staircase.
  for (const Surface& surface : { Potato(2), Torus(24, 12), Square(6) })
  {
    for (const double distance : { 1e6, 1e7, 1e9 })
    {
      const Result result = DirectionField(Placed<float>(surface, 1.0, distance)).Compute({});
      ASSERT_EQ(result.Components.size(), 1u);
      EXPECT_TRUE(result.Components[0].Converged);
      if (result.Components[0].Closed)
      {
        EXPECT_EQ(result.Components[0].IndexSum, 4 * result.Components[0].EulerCharacteristic);
      }
      for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
      {
        EXPECT_NEAR(result.Direction(i, 0).norm(), 1.0, 1e-9);
      }
    }
  }
}

TEST(Scales, MagnitudeIsOneInTheMeanSquare)
{
  // Whatever the scale and the resolution.
  for (const int level : { 3, 4 })
  {
    for (const double scale : { 1.0, 1000.0 })
    {
      for (const bool sharp : { false, true })
      {
        Options options;
        options.ConstrainSharpEdges = sharp;
        options.FeatureAngle = 5.0;
        const Surface surface =
          Transformed(Potato(level), scale * Eigen::Matrix3d::Identity(), { 0, 0, 0 });
        const Result result = DirectionField(surface).Compute(options);
        double square = 0.0;
        double area = 0.0;
        for (const Triangle& t : surface.Triangles)
        {
          const Vector3& p = surface.Points[t[0]];
          const double a = (surface.Points[t[1]] - p).cross(surface.Points[t[2]] - p).norm();
          for (const Index i : t)
          {
            square += a * std::norm(result.Representation[i]);
            area += a;
          }
        }
        EXPECT_NEAR(square / area, 1.0, 0.2);
      }
    }
  }
}

TEST(Scales, ExtremeSizesGiveFiniteFigures)
{
  for (const double size : { 1e-200, 1e-155, 1e155, 1e200 })
  {
    const Surface surface = Transformed(Potato(2), size * Eigen::Matrix3d::Identity(), { 0, 0, 0 });
    Options options;
    options.Alignment = Alignment::PrincipalCurvature;
    const Result result = DirectionField(surface).Compute(options);
    const ComponentReport& c = result.Components[0];
    EXPECT_TRUE(
      std::isfinite(c.Eigenvalue) && std::isfinite(c.Lambda) && std::isfinite(c.SmoothnessEnergy));
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      EXPECT_TRUE(std::isfinite(result.Curvature->Mean[i]));
      EXPECT_TRUE(std::isfinite(result.Curvature->Gaussian[i]));
      EXPECT_NEAR(result.Direction(static_cast<Index>(i), 0).norm(), 1.0, 1e-12);
    }
  }
}

TEST(Scales, ComponentsOfAllSizesSideBySide)
{
  // Each is solved in its own unit: neither drowns in the other.
  const Surface potato = Potato(2);
  const Result alone = ComputeExactly(potato);
  const Result both = ComputeExactly(Joined(potato, Placed<double>(potato, 1e-6, 3e6)));
  ASSERT_EQ(both.Components.size(), 2u);
  EXPECT_EQ(both.Components[0].Eigenvalue, alone.Components[0].Eigenvalue);
  EXPECT_NEAR(both.Components[1].Eigenvalue * 1e-12, alone.Components[0].Eigenvalue, 1e-6);
  for (const ComponentReport& component : both.Components)
  {
    EXPECT_EQ(component.IndexSum, 8);
  }
}

TEST(Scales, ASingleTriangleHasAParallelField)
{
  const Surface triangle{ { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const Result result = ComputeExactly(triangle);
  ASSERT_EQ(result.Components.size(), 1u);
  EXPECT_TRUE(result.Components[0].Converged);
  EXPECT_NEAR(result.Components[0].Eigenvalue, 0.0, 1e-12);
  EXPECT_EQ(result.Components[0].EulerCharacteristic, 1);
  for (Index i = 0; i < 3; ++i)
  {
    EXPECT_LT((result.Direction(i, 0) - Vector3::UnitX()).norm(), 1e-9);
  }
}

TEST(Scales, ThousandsOfComponentsAreWhatEachIsAlone)
{
  const Surface tetrahedron = Tetrahedron();
  const Result alone = ComputeExactly(tetrahedron);
  Surface many;
  constexpr Index count = 2000;
  for (Index k = 0; k < count; ++k)
  {
    for (const Vector3& p : tetrahedron.Points)
    {
      many.Points.push_back(p + Vector3(4.0 * k, 0.0, 0.0));
    }
    for (const Triangle& t : tetrahedron.Triangles)
    {
      many.Triangles.push_back({ t[0] + 4 * k, t[1] + 4 * k, t[2] + 4 * k });
    }
  }
  const Result result = ComputeExactly(many);
  ASSERT_EQ(result.Components.size(), static_cast<std::size_t>(count));
  for (Index k = 0; k < count; ++k)
  {
    EXPECT_NEAR(result.Components[k].Eigenvalue, alone.Components[0].Eigenvalue, 1e-7);
    EXPECT_EQ(result.Components[k].IndexSum, 8);
    EXPECT_EQ(result.Component[4 * k], k);
  }
}
