// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LineMeetings_h
#define DirectionFields_LineMeetings_h

#include "Streamlines/StreamlineTrace.h"

#include <functional>
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

/// All meetings of streamlines of which neither has come farther than a length, in an order that
/// depends on the streamlines only. Streamlines that start or end in the same singularity do not
/// meet there. On surfaces that cannot be oriented those of both sides meet.
/// @param lines  the pieces of each
/// @param isSame pairs that are the same line and hence do not meet
std::vector<Meeting> FindMeetings(const GivenField& field,
  const std::vector<const std::vector<LinePiece>*>& lines, double length,
  const std::function<bool(Index, Index)>& isSame);
}

#endif
