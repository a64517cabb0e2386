// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DihedralAngles_h
#define DirectionFields_DihedralAngles_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Signed angle between the normals of the two triangles of each edge, radians, positive where the
/// surface is convex; 0 on the boundary.
std::vector<double> DihedralAngles(const SurfaceGeometry& geometry);
}

#endif
