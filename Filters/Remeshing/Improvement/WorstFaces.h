// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WorstFaces_h
#define DirectionFields_WorstFaces_h

#include "FaceMesh/MovableFaces.h"
#include "Progress.h"

namespace DirectionFields::Internal
{
/// Moves a vertex with a bad face to the best of the places on two circles around it; the larger
/// radius is this number of quarters of the wanted length of edges. Faces are bad if they are far
/// from regular (a scaled Jacobian below 0.5), or if their center is far from the surface (a third
/// of an edge), where they cut off a ridge. No move makes the worst face at the vertex less
/// regular, unless it stays good.
void MoveToBetterPlace(MovableFaces& faces, Index v, double size);

/// Does that for all vertices of bad faces, usually few, several times with smaller and smaller
/// circles. Throws Stopped.
void ImproveWorstFaces(MovableFaces& faces, const Progress& progress = {});
}

#endif
