// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveSentences_h
#define DirectionFields_CurveSentences_h

#include "Types.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Whether a curve has no two different points.
bool IsDot(const std::vector<Vector3>& curve);

/// Sentences for the user, by the numbers of the points and curves that are left out: those far
/// from the surface, and curves without length.
std::string AboutFarPoints(const std::vector<Index>& points);
std::string AboutFarCurves(const std::vector<Index>& curves);
std::string AboutDots(const std::vector<Index>& curves);
}

#endif
