// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Thinning_h
#define DirectionFields_Thinning_h

#include "Decimation/Decimation.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The triangles of the front that a decimation leaves, as points of the surface.
std::vector<Triangle> TrianglesLeft(const TriangleMesh& mesh, const Decimation& decimation);

/// What a decimation of a surface may do. Where there are needles edges may be about as long as
/// others are there, so that these become fewer.
/// @param edgeLength longest edge at each point of the surface
/// @param hasNeedles as HasNeedles
/// @param isKept     not 0 for vertices that stay; empty for none
Decimation::Limits DecimationLimits(const SurfaceGeometry& geometry,
  const std::vector<double>& edgeLength, bool hasNeedles, std::vector<char> isKept);

/// Collapses edges inside that are much shorter than others around them, as splitting leaves them
/// around a point of hundreds of triangles. Features and the boundary stay. Returns the triangles
/// that are left.
/// @param isFeature not 0 for edges to be kept
/// @param longest   longest edge at each point of the surface
/// @param isKept    not 0 for vertices that stay; empty for none
std::vector<Triangle> ThinInside(const SurfaceGeometry& geometry,
  const std::vector<char>& isFeature, const std::vector<double>& longest, std::vector<char> isKept);
}

#endif
