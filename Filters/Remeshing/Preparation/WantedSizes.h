// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WantedSizes_h
#define DirectionFields_WantedSizes_h

#include "Geometry/SurfaceGeometry.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The area in units of the square of the size there. Coordinates that are not finite are refused later.
/// @param sizes one at each point, above 0
double RelativeArea(const Surface& surface, const std::vector<double>& sizes);

/// How long edges may become at each point where a mesh with fewer triangles will do for the map; empty where the
/// triangles are few already. Sizes within a factor of two share such a mesh, and what is computed on it.
/// @param area as RelativeArea
std::vector<double> LongestEdges(const std::vector<double>& sizes, double area, double edgeLength);

/// The least length of edges that gives about so many faces where the surface is thinner than a face: these are at the
/// boundary then, and its length counts, not the area.
/// @param sizes one at each vertex, above 0
double LeastEdgeLength(
  const SurfaceGeometry& geometry, const std::vector<double>& sizes, Index faces);
}

#endif
