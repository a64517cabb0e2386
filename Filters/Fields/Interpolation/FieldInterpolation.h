// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldInterpolation_h
#define DirectionFields_FieldInterpolation_h

#include "Interpolation/GivenField.h"
#include "Paths/SurfaceIncidence.h"

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

/// A direction field between the points where it is given: that of FieldInterpolant, which lines
/// follow, too. It is continuous across edges, equals the given one at the points, turns with the
/// surface, and does not depend on which of the directions comes first.
class FieldInterpolation
{
public:
  /// All must outlive this.
  /// @param given made of the surface and the field
  FieldInterpolation(
    const SurfaceIncidence& surface, const GivenField& given, const PointDirections& field);

  /// The directions at a place, in the triangle's plane. Point is the nearest corner of the
  /// triangle, and direction k is the one nearest to direction k of that. The normal is that of
  /// most triangles of the component, or the opposite one where the directions count the other way
  /// around.
  DirectionsAt At(const SurfacePoint& place) const;
  /// The directions that are given at a point, in its tangent plane.
  DirectionsAt AtPoint(Index point) const;

private:
  /// The unit direction 0 and |u| of a point; false where it has none.
  bool Read(Index point, Vector3& direction, double& magnitude) const;
  /// Unit normal of the plane of a point's directions.
  Vector3 Normal(Index point, const Vector3& direction, const Vector3& triangleNormal) const;
  /// Whether the directions at a corner of a triangle of the mesh count clockwise about its normal.
  bool CountsClockwise(Index point, Index vertex) const;

  const SurfaceIncidence& Surface;
  const GivenField& Given;
  const PointDirections& Field;
};
}

#endif
