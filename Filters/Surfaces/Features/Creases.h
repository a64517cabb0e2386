// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Creases_h
#define DirectionFields_Creases_h

#include "Geometry/SurfaceGeometry.h"

#include <functional>
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

  /// Drops creases of a single edge that ends inside of the surface. Where a surface has noise they
  /// are of it at a sliver, as there are some among random points.
  /// @param components whether to, for each component
  /// @param complete   replaces the values of vertices of which the mesh does not have all edges
  void DropSingleEdges(const TriangleMesh& mesh, const std::vector<char>& components,
    const std::function<void(std::vector<char>&)>& complete);

  /// Whether an edge is a crease, and whether a vertex is on one.
  std::vector<char> Edge;
  std::vector<char> Vertex;

private:
  void FindVertices(const TriangleMesh& mesh);
};
}

#endif
