// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EdgeChains_h
#define DirectionFields_EdgeChains_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Marked edges of a mesh, each with one end where the one before ends. A chain ends where one or
/// more than two marked edges meet, and on the boundary; closed ones have no such vertex.
struct EdgeChain
{
  std::vector<Index> Edges;
  /// One more than the edges; of a closed chain the last one is the first.
  std::vector<Index> Vertices;
  bool IsClosed = false;
  /// It has an end in the interior at which no other marked edge is.
  bool EndsFreely = false;

  double Length(const SurfaceGeometry& geometry) const;
};

/// The chains of all marked edges. Takes time linear in the mesh.
/// @param isMarked not 0 for each edge of a chain
std::vector<EdgeChain> ChainsOf(const TriangleMesh& mesh, const std::vector<char>& isMarked);
}

#endif
