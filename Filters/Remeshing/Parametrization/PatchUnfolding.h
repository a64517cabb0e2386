// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PatchUnfolding_h
#define DirectionFields_PatchUnfolding_h

#include "Parametrization/MovablePlaces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves the vertices of a patch of the map towards the least distortion of the triangles around them
/// by Newton's method, with second derivatives made positive, until none is flipped or this does not
/// come closer. Cones that the map goes around by the right angle keep it.
/// @param triangles all with a corner at one of the vertices
void UnfoldPatch(
  MovablePlaces& places, const std::vector<Index>& vertices, const std::vector<Index>& triangles);
}

#endif
