// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FlatFlips_h
#define DirectionFields_FlatFlips_h

#include "Geometry/SurfaceGeometry.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Turns edges to Delaunay where that leaves the surface where it is, in planes and along the
/// straight lines of strips that are bent one way only: where the two diagonals of a pair of
/// triangles pass each other closely. Returns the triangles of the front, as points of the surface.
/// @param isFixed not 0 for each edge that stays, as features
/// @param longest longest edge at each point of the surface; a hundredth of it is close
std::vector<Triangle> FlipFlat(const SurfaceGeometry& geometry, const std::vector<char>& isFixed,
  const std::vector<double>& longest);
}

#endif
