// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that move and change their shape little by little: their fields do so, too.

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// The turn between two fields of the same triangles in radians, in the mean over the surface and
/// with the sense of the normal, times the degree: -pi to pi. Their points' frames turn little.
double Turn(const Result& one, const Result& other)
{
  Complex sum = 0.0;
  for (Index i = 0; i < static_cast<Index>(one.Representation.size()); ++i)
  {
    const Vector3 x = one.XAxis[i];
    const Vector3 y = one.Normal[i].cross(x);
    const Complex frame(other.XAxis[i].dot(x), other.XAxis[i].dot(y));
    sum += std::conj(one.Representation[i]) * other.Representation[i] *
      std::polar(1.0, one.Degree * std::arg(frame));
  }
  return std::arg(sum);
}
}

TEST(TimeSeries, FieldsFollowTheOneBefore)
{
  // Rotating, swinging and bulging; some so symmetric that the x axis says nothing at times.
  const auto rotated = [](const Surface& surface, double t)
  {
    const auto rotation = Eigen::AngleAxisd(t, Vector3(1.0, 2.0, 0.5).normalized());
    return Transformed(surface, rotation.toRotationMatrix(), Vector3::Zero());
  };
  const std::function<Surface(double)> shapes[] = {
    [&](double t) { return rotated(Potato(2), t); },
    [&](double t) { return rotated(Torus(24, 12), t); },
    [&](double t) { return rotated(MoebiusStrip(40, 4), t); },
    [](double t)
    {
      Surface surface = Potato(2);
      for (Vector3& p : surface.Points)
      {
        p.x() *= 1.0 + 0.3 * std::sin(t);
        p.z() += 0.2 * std::sin(t + p.x());
      }
      return surface;
    },
  };
  constexpr int steps = 60;
  double alone = 0.0;
  for (const auto& shape : shapes)
  {
    for (const int degree : { 1, 2, 4 })
    {
      Options options;
      options.Degree = degree;
      options.Tolerance = 1e-9;
      Result previous = DirectionField(shape(0.0)).Compute(options);
      Result unrelated = previous;
      // Forward for two thirds of the steps, then back.
      for (int k = 1; k <= steps; ++k)
      {
        const double t = 2.0 * Pi * std::min(k, 80 - k) / steps;
        const Surface surface = shape(t);
        DirectionField field(surface);
        const Result byItself = field.Compute(options);
        std::vector<Vector3> directions;
        for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
        {
          directions.push_back(
            std::abs(previous.Representation[i]) * previous.Direction(i, k % degree));
        }
        field.SetPhaseReference(directions, degree);
        const Result next = field.Compute(options);
        // Of the half turn that would be the most; the shapes themselves turn by 6 degrees a step.
        EXPECT_LT(std::abs(Turn(previous, next)), 0.15 * Pi) << degree << " " << k;
        EXPECT_NEAR(next.Components[0].Eigenvalue, byItself.Components[0].Eigenvalue, 1e-12);
        EXPECT_EQ(next.SingularityIndex, byItself.SingularityIndex);
        alone = std::max(alone, std::abs(Turn(unrelated, byItself)));
        previous = next;
        unrelated = byItself;
      }
    }
  }
  // Without the reference there are jumps.
  EXPECT_GT(alone, 0.9 * Pi);
}

TEST(TimeSeries, OnlyTheSmoothestFieldOfTheSameDegreeIsTurned)
{
  const Surface surface = Potato(2);
  const std::vector<Vector3> oblique(surface.Points.size(), Vector3(0.2, 1.0, 0.4));
  using Vectors = std::vector<Vector3>;
  const auto compute = [&](const Options& options, const Vectors& reference, int degree)
  {
    DirectionField field(surface);
    field.SetPhaseReference(reference, degree);
    return field.Compute(options).Representation;
  };
  Options options;
  const auto expected = DirectionField(surface).Compute(options).Representation;
  EXPECT_NE(compute(options, oblique, 4), expected);
  EXPECT_EQ(compute(options, oblique, 2), expected);
  EXPECT_EQ(compute(options, { Vector3::UnitX() }, 4), expected);
  EXPECT_EQ(compute(options, std::vector<Vector3>(oblique.size(), Vector3::Zero()), 4), expected);
  options.Alignment = Alignment::PrincipalCurvature;
  EXPECT_EQ(compute(options, oblique, 4), DirectionField(surface).Compute(options).Representation);
}
