// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_InterpolantZero_h
#define DirectionFields_InterpolantZero_h

#include "Interpolation/FieldInterpolant.h"

namespace DirectionFields::Internal
{
/// Where the section vanishes in a triangle.
struct InterpolantZero
{
  /// In the flat triangle, with all barycentric coordinates at least LeastWeight.
  Complex Place;
  /// Of the section there.
  FieldInterpolant::Jet Jet;
  /// Whether the section is 0 there, up to rounding. Else the place is where it was found smallest:
  /// a zero on the rim of the triangle.
  bool Converged = false;

  /// +1 where the directions turn like a vector from the zero, -1 where they turn against it: the
  /// triangle's index, if it is +1 or -1.
  int Sign() const { return this->Jet.Determinant() >= 0.0 ? 1 : -1; }

  static constexpr double LeastWeight = 1e-4;
};

/// A zero of the section by Newton's method from the centroid, with steps that are halved until |q|
/// falls, within the triangle; from a few other places, too, where that fails. Meant for triangles
/// whose index is not 0: these have one.
/// @param sign of the zero, where there may be several: +1, -1, or 0 for any
InterpolantZero FindZero(const FieldInterpolant& interpolant, int sign = 0);
}

#endif
