// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConeOpening_h
#define DirectionFields_ConeOpening_h

#include "Unfolding/MovablePlaces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Gives the vertices around a cone in the middle of a triangle the places that polar coordinates
/// around it have: angles are stretched such that the map goes around the cone by the angle that it
/// is to have, and turned together as it suits the places before. A map that goes around by another
/// one can be unfolded, too, but it then goes twice around a vertex beside the cone.
/// @param movable vertices that may move, ascending
/// @param corners all vertices whose places count, ascending: those and the others of the triangles
///                at them
/// @param radius within which they do, the less the farther away, in edges of the grid; the three
/// next ones always
void OpenCone(MovablePlaces& places, Index cone, const std::vector<Index>& movable,
  const std::vector<Index>& corners, double radius);
}

#endif
