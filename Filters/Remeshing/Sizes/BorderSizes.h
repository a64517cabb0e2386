// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BorderSizes_h
#define DirectionFields_BorderSizes_h

#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The longest lengths of edges at the points of a surface with which borders of regions that are
/// arcs are a thousandth of the diagonal from their chords at most. Edges stay as they are where
/// they would have to be shorter than .55 of the wanted length, or that is more than .035 of the
/// diagonal. Infinite where edges may be as long as wanted; empty if that is everywhere.
/// @param regions    of the triangles; empty for one region
/// @param edgeLength the wanted one
std::vector<double> LengthsAtBorders(
  const Surface& surface, const std::vector<Index>& regions, double edgeLength);
}

#endif
