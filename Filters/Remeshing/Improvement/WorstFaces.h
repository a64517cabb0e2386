// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WorstFaces_h
#define DirectionFields_WorstFaces_h

#include "FaceMesh/MovableFaces.h"
#include "Progress.h"

namespace DirectionFields::Internal
{
/// Moves a vertex with a bad face to the best of places on two circles around it, whose radii are this many quarters
/// of the wanted length of edges and less. Bad are faces that are far from regular (a scaled Jacobian below 0.5), and
/// such whose middle is far from the surface (a third of an edge), where they cut off a ridge. No move makes the worst
/// face at the vertex less regular, unless it stays good.
void MoveToBetterPlace(MovableFaces& faces, Index v, double size);

/// Does that for all vertices of bad faces, few as a rule, several times with ever smaller circles. Throws Stopped.
void ImproveWorstFaces(MovableFaces& faces, const Progress& progress = {});
}

#endif
