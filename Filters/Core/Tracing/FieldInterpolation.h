// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldInterpolation_h
#define DirectionFields_FieldInterpolation_h

#include "Interpolation/GivenField.h"
#include "Tracing/SurfaceIncidence.h"

namespace DirectionFields::Internal
{
/// The n directions at one place.
struct DirectionsAt
{
  Vector3 Position;
  /// Unit normal of the plane that the directions lie in.
  Vector3 Normal;
  /// Direction 0.
  Vector3 Direction;
  /// |u|. 0 where there are no directions.
  double Magnitude = 0.0;
  /// The point of the surface that numbers the directions.
  Index Point = None;

  /// Direction k of a field of degree n.
  Vector3 Turned(int k, int degree) const;
};

/// A direction field between the points where it is given.
///
/// What is interpolated are not the directions, which are defined up to a turn by 2 pi / n, but
/// their n-th powers u = |u| exp(i n phi), which are not: u(x) = sum over the triangle's corners of
/// hat_j(x) u_j. Each u_j is first carried to the tangent plane at x by the least rotation that
/// takes the normal at j to the normal at x, which is interpolated as well. So the field is
/// continuous across edges, equals the given one at the points, turns with the surface, and does
/// not depend on which of the directions comes first. A last least rotation lays it into the
/// triangle, for what is seen is flat.
class FieldInterpolation
{
public:
  FieldInterpolation(const SurfaceIncidence& surface, const PointDirections& field);

  /// The directions at a place, in the triangle's plane. Point is the nearest corner of the triangle, and
  /// direction k is the one nearest to direction k of that.
  DirectionsAt At(const SurfacePoint& place) const;
  /// The directions that are given at a point, in its tangent plane.
  DirectionsAt AtPoint(Index point) const;

private:
  struct Corners;

  /// The unit direction 0 and |u| of a point; false where it has none.
  bool Read(Index point, Vector3& direction, double& magnitude) const;
  /// Unit normal of the plane of a point's directions.
  Vector3 Normal(Index point, const Vector3& direction, const Vector3& triangleNormal) const;
  Corners ReadCorners(Index triangle) const;

  const SurfaceIncidence& Surface;
  const PointDirections& Field;
};
}

#endif
