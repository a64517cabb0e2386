// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_OwnedParts_h
#define DirectionFields_OwnedParts_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The parts of a mesh that count in sums over it. Of a cover one side counts. Where triangles are
/// there as ghosts of other pieces (Surface::Ghost), such a triangle counts in the piece that it
/// belongs to, and a vertex or an edge in the piece of that one of its triangles whose corners are
/// lexicographically first. So everything on a surface in pieces is counted once, wherever each
/// piece has for ghosts all the triangles that touch its own.
struct OwnedParts
{
  /// @param surface of the mesh
  OwnedParts(const TriangleMesh& mesh, const Surface& surface);

  /// The counted parts of a component.
  struct Counts
  {
    Index Vertices = 0;
    Index Edges = 0;
    Index Triangles = 0;
    Index Ghosts = 0;
  };
  std::vector<Counts> Components;
  /// 1 for vertices that count; empty where everything does.
  std::vector<char> Vertex;

private:
  void LeaveOutGhosts(const TriangleMesh& mesh, const Surface& surface);
};
}

#endif
