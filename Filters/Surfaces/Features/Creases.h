// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Creases_h
#define DirectionFields_Creases_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Edges where a surface is bent and not curved, as on machine parts. No smooth surface is to be
/// fitted across them.
struct Creases
{
  /// An edge is a crease where its normals enclose more than 30 degrees, where this is three times
  /// as much as at all but two edges of one of its ends, and where the surface beyond its two
  /// triangles agrees. Noise and coarse round surfaces bend all edges alike.
  /// @param dihedralAngles of each edge
  Creases(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles);

  /// Whether an edge is a crease, and whether a vertex is on one.
  std::vector<char> Edge;
  std::vector<char> Vertex;
};
}

#endif
