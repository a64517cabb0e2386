// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/TriangleDistortion.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Derivative = TriangleDistortion::Derivative;

std::vector<Derivative> Examples()
{
  return { { 1.0, 0.0, 0.0, 1.0 }, { 0.8, 0.3, -0.2, 1.4 }, { 0.1, 0.5, 0.4, -0.3 },
    { -0.6, 0.2, 0.1, 0.7 }, { 0.01, 0.0, 0.3, 2.0 } };
}
}

/// Central differences of the values and of the gradients, for triangles that are flipped, too.
TEST(TriangleDistortion, HasItsDerivatives)
{
  constexpr double step = 1e-5;
  for (const double epsilon : { 0.3, 0.05 })
  {
    for (const Derivative& j : Examples())
    {
      const TriangleDistortion at(j, epsilon);
      for (int k = 0; k < 4; ++k)
      {
        const TriangleDistortion after(j + step * Derivative::Unit(k), epsilon);
        const TriangleDistortion before(j - step * Derivative::Unit(k), epsilon);
        EXPECT_NEAR((after.Value - before.Value) / (2.0 * step), at.Gradient[k],
          1e-6 * (1.0 + at.Hessian.norm()));
        EXPECT_EQ(TriangleDistortion::ValueOf(j, epsilon), at.Value);
        EXPECT_LT(((after.Gradient - before.Gradient) / (2.0 * step) - at.Hessian.col(k)).norm(),
          1e-6 * (1.0 + at.Hessian.norm() * at.Value));
      }
    }
  }
}

/// Rotations have the least, 2 + 2 w, and turning the image or the triangle changes nothing.
TEST(TriangleDistortion, IsLeastForRotations)
{
  const auto turned = [](const Derivative& j, double before, double after)
  {
    Eigen::Matrix2d m;
    m << j[0], j[1], j[2], j[3];
    const Eigen::Matrix2d t = Eigen::Rotation2Dd(after).toRotationMatrix() * m *
      Eigen::Rotation2Dd(before).toRotationMatrix();
    return Derivative(t(0, 0), t(0, 1), t(1, 0), t(1, 1));
  };
  const TriangleDistortion least(Examples().front(), 0.0);
  EXPECT_NEAR(least.Value, 2.4, 1e-14);
  EXPECT_LT(least.Gradient.norm(), 1e-14);
  for (const Derivative& j : Examples())
  {
    const TriangleDistortion at(j, 0.1);
    EXPECT_NEAR(at.Value, TriangleDistortion(turned(j, 0.7, -1.9), 0.1).Value, 1e-12 * at.Value);
    if (TriangleDistortion::Determinant(j) > 0.0)
    {
      EXPECT_GE(TriangleDistortion(j, 0.0).Value, least.Value - 1e-14);
    }
  }
}

/// Without epsilon it grows beyond all bounds towards flat triangles.
TEST(TriangleDistortion, IsInfiniteWhereATriangleIsFlipped)
{
  EXPECT_GT(TriangleDistortion({ 1.0, 0.0, 0.0, 1e-9 }, 0.0).Value, 1e8);
  EXPECT_FALSE(std::isfinite(TriangleDistortion({ 1.0, 0.0, 0.0, -0.5 }, 0.0).Value));
  for (const double epsilon : { 1e-3, 1e-6, 1e-9 })
  {
    const TriangleDistortion flipped({ 1.0, 0.0, 0.0, -0.5 }, epsilon);
    EXPECT_TRUE(std::isfinite(flipped.Value) && flipped.Gradient.allFinite());
    EXPECT_TRUE(flipped.Hessian.allFinite());
    // Far beyond the fold chi is epsilon^2 / 4 |d|.
    EXPECT_NEAR(flipped.Value * epsilon * epsilon, 4.0 * 0.5 * (1.25 + 0.2 * 1.25), 1e-4);
  }
}

/// The nearest ones: eigenvalues below 0 become 0, and the eigenvectors stay. Also for maps that keep
/// angles, and that reflect, which have no direction of the other part.
TEST(TriangleDistortion, HasConvexSecondDerivatives)
{
  std::vector<Derivative> examples = Examples();
  examples.insert(examples.end(),
    { { 0.6, -0.8, 0.8, 0.6 }, { -0.03, 0.04, 0.04, 0.03 }, { -0.7, 0.1, 0.6, 0.9 },
      Derivative::Zero() });
  int changed = 0;
  for (const double epsilon : { 1.0, 0.1, 1e-3 })
  {
    for (const Derivative& j : examples)
    {
      TriangleDistortion convex(j, epsilon);
      const Eigen::Matrix4d before = convex.Hessian;
      convex.Convexify();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(before);
      const Eigen::Matrix4d nearest = solver.eigenvectors() *
        solver.eigenvalues().cwiseMax(0.0).asDiagonal() * solver.eigenvectors().transpose();
      EXPECT_LT((convex.Hessian - nearest).norm(), 1e-13 * before.norm());
      changed += solver.eigenvalues()[0] < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 12);
}
