// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripeBands_h
#define DirectionFields_StripeBands_h

#include "Stripes/StripePieces.h"

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// The surface cut along the borders of a pattern's stripes, into convex polygons, each within a
/// triangle. Polygons share their points: a closed surface gives closed bands.
struct StripeBands
{
  /// @param pieces  of the levels of kind Borders
  /// @param isGhost of each triangle of the surface, which is left out then; or empty
  StripeBands(const StripePieces& pieces, const std::vector<char>& isGhost, bool withPhases);

  /// The points of all polygons as StripePieces number them: those of polygon i are
  /// Corners[Offsets[i]] ... Corners[Offsets[i + 1] - 1], counter-clockwise, as numbers of Points.
  std::vector<std::int64_t> Points;
  std::vector<std::int64_t> Corners;
  std::vector<std::int64_t> Offsets = { 0 };
  /// 1 within a quarter of the spacing from the middle of a stripe, where lines are; 0 between
  /// those.
  std::vector<char> Stripe;
  /// The triangle of the surface.
  std::vector<Index> Triangle;
  /// The phase at each corner in cycles, 0 in the middle of a stripe, as a linear function on the
  /// polygon; from one triangle to the next it may jump by whole cycles and change its sign. Empty
  /// if not asked for.
  std::vector<float> Phases;
};
}

#endif
