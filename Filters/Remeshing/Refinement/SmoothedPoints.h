// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SmoothedPoints_h
#define DirectionFields_SmoothedPoints_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The points of a surface with those of its vertices moved, in each step, half the way to the mean
/// of their neighbours. Vertices of the boundary and of features stay.
/// @param points    of the surface that the geometry is of
/// @param isFeature not 0 for each edge that is a feature
/// @param steps     at least 0; waves of about as many edges as its root vanish
std::vector<Vector3> SmoothedPoints(const SurfaceGeometry& geometry, std::vector<Vector3> points,
  const std::vector<char>& isFeature, int steps);

/// The points of a surface with those along features moved, in each step, half the way to the mean
/// of their two neighbours there. Places where features meet or end, the boundary, and hard edges
/// stay.
/// @param isHard empty for none
std::vector<Vector3> WithSmoothLines(const TriangleMesh& mesh, std::vector<Vector3> points,
  const std::vector<char>& isFeature, const std::vector<char>& isHard, int steps);
}

#endif
