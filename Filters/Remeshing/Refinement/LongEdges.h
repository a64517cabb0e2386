// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LongEdges_h
#define DirectionFields_LongEdges_h

#include "Geometry/SurfaceGeometry.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Whether a surface has triangles that the map cannot do with: the slivers around a point of more
/// than 50, or triangles much thinner than a face and longer on more than a twentieth of its area,
/// as on the walls and lids of finely tessellated cylinders.
/// @param face length of an edge of the mesh to be made
bool HasNeedles(const Surface& surface, double face);

/// Whether most of the area is of triangles that have a neighbour in their plane, as CAD programs
/// write them, or none at all, and of those at the boundary or at a rim. The triangles of others
/// are their shape: parts of them have no curvature.
bool IsMostlyFlat(const SurfaceGeometry& geometry);

/// Not 0 for each edge that is longer than it may be; of more than there is room for, the longest.
/// @param longest     longest edge at each point of the surface; an edge may be as long as at the
///                    end where less is allowed
/// @param mostMiddles how many edges may be chosen
std::vector<char> FindLongEdges(
  const SurfaceGeometry& geometry, const std::vector<double>& longest, Index mostMiddles);
}

#endif
