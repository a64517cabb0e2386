// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SharpCorners_h
#define DirectionFields_SharpCorners_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// What a field of degree n needs inside of corners where two features, or features and the
/// boundary, meet at an angle of less than 5/9 of 2 pi / n. A field that follows both sides turns
/// least by not changing from one direction to the next between them, or as much either way where
/// the angle is half of 2 pi / n. Then both sides are parallel in a map, which has no room for the
/// corner. Directions half of 2 pi / n off the middle between the sides, given near the corner,
/// make it the corner of a face; the field has a singularity of index 1 / n where they end.
struct SharpCorners
{
  /// @param isFeature not 0 for each edge that is a feature
  /// @param face      the usual length of an edge of the mesh to be made; smaller corners are left
  SharpCorners(
    const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature, double face);

  /// One for each vertex, of length 1; zero where any direction does, and on the sides.
  std::vector<Vector3> Directions;
  /// Not 0 for the edges from one side to the other: along one of them a field would turn the short
  /// way, so that they need a vertex in the middle.
  std::vector<char> IsChord;
  /// Not 0 for the vertices at such corners of the boundary: there a line of a map has to end, and
  /// not beside.
  std::vector<char> IsEnd;
};
}

#endif
