// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StreamlinePoints_h
#define DirectionFields_StreamlinePoints_h

#include "Streamlines.h"
#include "Streamlines/TracedStreamline.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The points of streamlines in space with their arrays, and the nodes, on the threads of the
/// scope.
/// @param lines  each with pieces
/// @param height of the points above the surface, in its unit
Streamlines ToStreamlines(const GivenField& field, const PointDirections& directions,
  const SingularPoints& zeros, const std::vector<TracedStreamline>& lines, double height);
}

#endif
