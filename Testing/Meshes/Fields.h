// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Fields_h
#define DirectionFields_Fields_h

#include "DirectionField.h"
#include "Interpolation/FieldInterpolation.h"

#include <cmath>

/// Fields for the tests, and fields in the form that streamlines, stripes and glyphs take.
namespace Fields
{
using namespace DirectionFields;

/// A field on the plane z = 0 whose n directions at a point are turned by an angle.
template <typename Angle>
PointDirections PlanarField(const Surface& surface, int degree, const Angle& angle)
{
  PointDirections field;
  field.Degree = degree;
  field.Direction = [&surface, degree, angle](Index point, int k)
  {
    const double phi = angle(surface.Points[point]) + 2.0 * Pi * k / degree;
    return Vector3(std::cos(phi), std::sin(phi), 0.0);
  };
  field.Magnitude = [](Index) { return 1.0; };
  return field;
}

/// A field that was computed, which must outlive the returned one.
inline PointDirections Of(const Result& result)
{
  return DirectionsOf(result);
}

/// The smoothest field.
inline Result Compute(
  const Surface& surface, int degree, double bias = 0.0, double tolerance = Options().Tolerance)
{
  Options options;
  options.Degree = degree;
  options.EnergyBias = bias;
  options.Tolerance = tolerance;
  return DirectionField(surface).Compute(options);
}
}

#endif
