// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripeLines_h
#define DirectionFields_StripeLines_h

#include "Stripes/StripePieces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// Levels of a stripe pattern joined to lines, each as long as can be. They run with the higher
/// phases to their left where the pattern has one sheet.
struct StripeLines
{
  /// @param isGhost of each triangle of the surface, which has no lines then; or empty
  StripeLines(const StripePieces& pieces, const std::vector<char>& isGhost);

  /// The points of line i, Offsets[i] ... Offsets[i + 1] - 1, as StripePieces number them. A closed
  /// line ends in its first point.
  std::vector<std::int64_t> Points;
  std::vector<std::int64_t> Offsets = { 0 };
  std::vector<char> Closed;
  /// The centers that lines begin and end in; None at the boundary, and where they are closed.
  std::vector<std::array<Index, 2>> EndCenters;
};
}

#endif
