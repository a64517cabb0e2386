// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LinePoints_h
#define DirectionFields_LinePoints_h

#include "Lines/FieldLines.h"
#include "Lines/TracedLine.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The points of lines in space, what is known at them, and the nodes, on the threads of the scope.
/// @param lines  each with pieces
/// @param height of the points above the surface, in its unit
FieldLines ToFieldLines(const GivenField& field, const PointDirections& directions,
  const FieldZeros& zeros, const std::vector<TracedLine>& lines, double height);
}

#endif
