// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveDivision_h
#define DirectionFields_CurveDivision_h

#include "Guidance/CurveGuidance.h"

#include <vector>

namespace DirectionFields
{
/// Divides curves among several surfaces, such as the blocks of a dataset, so that each surface is
/// guided only by what runs on it: each piece of a curve, half a mean edge of the finest surface
/// long, goes to the surface that it is nearest to. Where others are as near, within a tenth of
/// that edge, as beside a common seam or on a copy of the surface, it goes to the one of these that
/// most of the curve is as near to; of equal ones to the first.
///
/// Each segment on one surface alone keeps its end points to the bit. Throws Stopped.
/// @param surfaces not null; those without triangles get nothing
/// @param curves   as in GuideByCurves
/// @return for each surface as many curves as were given, their pieces divided by places that are
///         not finite; empty where it has no piece of one. A curve that is far from all surfaces
///         goes to the nearest one
std::vector<std::vector<std::vector<Vector3>>> DivideCurves(
  const std::vector<SurfaceCurves*>& surfaces, const std::vector<std::vector<Vector3>>& curves,
  const Progress& progress = {});
}

#endif
