// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundaryMatch_h
#define DirectionFields_BoundaryMatch_h

#include "Boundary/BoundarySides.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Which point of the line each vertex of a side is to become, as a whole place in their order, or
/// None for vertices that are too many. As few as can be are, and as few points have no vertex;
/// among these ways it is the one that moves vertices least, in squares of the distances in units
/// of the line's edges. The first and the last vertex have the places nearest to theirs, and so has
/// each vertex that stays; empty where these contradict each other. Takes time linear in both.
/// @param stays not 0 for the vertices of the side that do not move
std::vector<Index> MatchBoundary(
  const BoundarySide& side, const BoundaryLine& line, const std::vector<char>& stays);
}

#endif
