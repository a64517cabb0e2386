// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PolygonEars_h
#define DirectionFields_PolygonEars_h

#include "Types.h"

#include <vector>

namespace DirectionFields
{
/// Whether a polygon comes back to a place where it has been, other than from one corner to the
/// next.
bool ReturnsToPlaces(const std::vector<Vector3>& corners);

/// Cuts a polygon into triangles by its ears (Meisters 1975), the best shapes first, as seen along
/// its mean normal. The time is nearly linear in the corners: an ear that contains another corner
/// waits until that one is cut off, and a grid finds it.
///
/// The polygon may touch itself. Where it comes back to a place, each visit has its own part of the
/// surroundings: a hole that is joined to the outline by a bridge, which is run along in both
/// directions, stays one. Where it turns back on the spot, or closes a loop at a place, no triangle
/// is made of a part without area.
///
/// @param corners finite
/// @param force   also cuts a polygon that crosses itself or has no area, in some way in which few
///                triangles meet in a corner
/// @return the corners of the triangles, three each, wound as the polygon; empty for a polygon that
///         crosses itself or has no area, if that is not forced
std::vector<Index> CutEars(const std::vector<Vector3>& corners, bool force);
}

#endif
