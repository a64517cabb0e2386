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
  /// Replaces the second derivatives by the nearest that no direction has less than 0 of. Their
  /// eigenvectors are known, as turning the image or the triangle changes nothing (B. Smith et al.:
  /// Analytic eigensystems for isotropic distortion energies, 2019): a turn against the part of the
  /// map that keeps angles, one against the part that reflects, and two in the plane of both parts.
  void Convexify();

  double Value;
  Derivative Gradient;
  Eigen::Matrix4d Hessian;

private:
  /// Of the second derivatives: 1/2 of that by |J|^2 counts in all directions, that of the
  /// determinant by J once, and with its gradient squared and times J.
  struct Factors
  {
    double All;
    double OfDeterminant;
    double Squared;
    double Mixed;
  };
  Derivative J;
  Factors Of;
};
}

#endif
