// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_HoleBands_h
#define DirectionFields_HoleBands_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Directions around holes in planes, in a band beside the rim of each: at a right angle to the
/// shortest way to the rim. The smoothest field of degree n has n singularities around a hole of
/// radius R, 1.1 to 1.3 R from its middle. The rows of a map that end at the rim have to fit
/// between them, and where rows have to begin or end, as around a hub, the map over the reals folds
/// in these narrow places, for edges of any length. Outside of a band there is room.
///
/// A rim is a closed line of features or of the boundary that turns by less than pi / n at each
/// vertex. A band is 0.7 R wide, at least 2 and at most 5 lengths of edges, and at most a third of
/// the distance from the rim to another line.
/// @param isFeature  not 0 for each edge that is a feature; the boundary counts, too
/// @param edgeLength usual one of the mesh to be made, in the surface's unit
/// @return one for each vertex, of length 1; zero outside of the bands and on lines
std::vector<Vector3> HoleBands(const SurfaceGeometry& geometry, int degree,
  const std::vector<char>& isFeature, double edgeLength);
}

#endif
