// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DuplicateTriangles_h
#define DirectionFields_DuplicateTriangles_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Finds the superfluous triangles of a surface, whatever their order. Of those with the same
/// corners and the same winding only the first is needed.
///
/// Two of opposite windings are the two sides of a sheet. One of them is enough where the sheet
/// ends in the open, or goes on as one other sheet: back to back triangles stand for a surface that
/// is to be seen from both sides. Both are needed where two other sheets go on from its edges,
/// wound so that each continues one of the sides: at a corner of a pillow, whose sheets share their
/// border, or in the wall between two closed cells. To remove one would open a closed surface.
/// Triangles that are connected by edges of such triangles are decided together, by the majority of
/// its other edges.
///
/// @param corners three of each triangle, all different
/// @return 1 for each triangle that is not needed
std::vector<char> FindDuplicateTriangles(const LargeArray<Index>& corners);
}

#endif
