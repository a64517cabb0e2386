// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PatchUnfolding_h
#define DirectionFields_PatchUnfolding_h

#include "Progress.h"
#include "Unfolding/MovablePlaces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves the vertices of a patch of the map towards the least distortion of the triangles at them
/// by Newton's method, with second derivatives made positive, until none is flipped or they hardly
/// come closer to that. Cones that the map goes around by the right angle keep it. Patches of more
/// than 20 000 coordinates stay as they are. Throws Stopped.
/// @param triangles all with a corner at one of the vertices
void UnfoldPatch(MovablePlaces& places, const std::vector<Index>& vertices,
  const std::vector<Index>& triangles, const Progress& progress = {});
}

#endif
