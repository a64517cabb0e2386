// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TriangleDistortion_h
#define DirectionFields_TriangleDistortion_h

#include "Types.h"

#include <Eigen/Core>

namespace DirectionFields::Internal
{
/// How far a linear map of a triangle is from one that keeps its shape and its area, with
/// derivatives. Of the map's derivative J it is (|J|^2 + w (det^2 J + 1)) / chi(det J), where
/// chi(d) = (d + sqrt(d^2 + epsilon^2)) / 2 is d for epsilon = 0: not finite where the map flips
/// the triangle or lays it flat. With a larger epsilon it is finite there, and the smaller the
/// less the triangle is flipped (V. Garanzha et al.: Foldover-free maps in 50 lines of code,
/// 2021).
struct TriangleDistortion
{
  using Derivative = Eigen::Vector4d;

  /// @param j the two rows of the derivative
  TriangleDistortion(const Derivative& j, double epsilon);

  static double Determinant(const Derivative& j) { return j[0] * j[3] - j[1] * j[2]; }
  /// The value alone.
  static double ValueOf(const Derivative& j, double epsilon);
  /// Replaces the second derivatives by the nearest that no direction has less than 0 of.
  void Convexify();

  double Value;
  Derivative Gradient;
  Eigen::Matrix4d Hessian;
};
}

#endif
