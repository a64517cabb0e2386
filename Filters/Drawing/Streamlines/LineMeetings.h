// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LineMeetings_h
#define DirectionFields_LineMeetings_h

#include "Streamlines/StreamlineTrace.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// Where a line comes to the trail of another one, or to its own.
struct Meeting
{
  Index Line, Other;
  /// The lengths of the two up to there; Early is that of the other one and not larger.
  double Late, Early;
};

/// A streamline as far as others can meet it: the pieces that begin up to a length.
struct Trail
{
  const std::vector<LinePiece>* Pieces;
  double Length;
};

/// All meetings of the trails of streamlines, in an order that depends on these only. Streamlines
/// that start or end in the same singularity do not meet there. On surfaces that cannot be oriented
/// those of both sides meet.
/// @param isSame pairs that are the same line and hence do not meet
/// @param most   nothing is returned where there are more meetings than that: lines that wind
///               around may have as many as the square of their pieces
std::optional<std::vector<Meeting>> FindMeetings(const GivenField& field,
  const std::vector<Trail>& trails, const std::function<bool(Index, Index)>& isSame,
  std::size_t most);
}

#endif
