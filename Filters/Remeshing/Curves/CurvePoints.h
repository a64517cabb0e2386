// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurvePoints_h
#define DirectionFields_CurvePoints_h

#include "Types.h"

#include <cstddef>
#include <vector>

namespace DirectionFields::Internal
{
/// The points of a curve that are farther from each other than a distance, and its last one.
std::vector<Vector3> Apart(const std::vector<Vector3>& curve, double distance);

/// How far a point of a curve is from those before and after it.
double RoomAt(const std::vector<Vector3>& curve, std::size_t i);
}

#endif
