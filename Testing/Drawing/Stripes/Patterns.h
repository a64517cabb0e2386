// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Patterns_h
#define DirectionFields_Patterns_h

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Stripes.h"

/// Stripe patterns for the tests, and measurements of them.
namespace Patterns
{
using namespace DirectionFields;

inline StripeOptions Spaced(double spacing, StripeDirection direction = StripeDirection::Along)
{
  StripeOptions options;
  options.Spacing = spacing;
  options.Direction = direction;
  return options;
}

inline StripePattern PatternOf(
  const Surface& surface, const PointDirections& directions, const StripeOptions& options)
{
  const GivenField field(surface, directions);
  return MakeStripes(field, options);
}

inline StripePattern SmoothPattern(const Surface& surface, int degree, const StripeOptions& options)
{
  const Result result = Fields::Compute(surface, degree);
  return PatternOf(surface, Fields::Of(result), options);
}

/// Around the z axis.
inline PointDirections East(const Surface& surface)
{
  PointDirections field;
  field.Degree = 1;
  field.Direction = [&surface](Index point, int)
  {
    const Vector3 east(-surface.Points[point].y(), surface.Points[point].x(), 0.0);
    return east.norm() > 1e-9 ? Vector3(east.normalized()) : Vector3(1.0, 0.0, 0.0);
  };
  field.Magnitude = [](Index) { return 1.0; };
  return field;
}

/// The lines of a vector field, in random order and senses.
inline PointDirections AsLineField(const PointDirections& vectors)
{
  PointDirections lines = vectors;
  lines.Degree = 2;
  lines.Direction = [vectors](Index point, int k)
  { return Vector3(((point * 7919 / 5 + k) % 2 == 0 ? 1.0 : -1.0) * vectors.Direction(point, 0)); };
  return lines;
}

inline double AreaOf(const Surface& surface)
{
  double area = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3 a = surface.Points[t[1]] - surface.Points[t[0]];
    area += 0.5 * a.cross(surface.Points[t[2]] - surface.Points[t[0]]).norm();
  }
  return area;
}

inline double LengthOf(const StripePattern& pattern)
{
  double length = 0.0;
  for (const double line : pattern.Length)
  {
    length += line;
  }
  return length;
}

inline int IndexSum(const StripePattern& pattern)
{
  int sum = 0;
  for (const StripeSingularity& singularity : pattern.Singularities)
  {
    sum += singularity.StripeIndex;
  }
  return sum;
}
}

#endif
