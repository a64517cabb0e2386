// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceMesh_h
#define DirectionFields_FaceMesh_h

#include "FaceMesh/Faces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A mesh of triangles and quads, and the role of its vertices on the surface.
struct FaceMesh
{
  struct Vertex
  {
    /// The feature of the vertex, from 1 on; 0 for vertices that are free on the surface, -1 for
    /// vertices that do not move.
    Index Line = 0;
    /// Where sheets of a surface meet, too.
    bool IsBoundary = false;
    /// A singularity of the field.
    bool IsCone = false;
    /// Of the field, in units of 1/n; 0 but at cones.
    int SingularityIndex = 0;
    /// The vertex of the surface's mesh that it is, or None for new ones.
    Index Origin = None;
    /// The feature of a vertex that is held in its place for a while, whose Line is -1 then, or 0.
    Index Held = 0;
  };
  /// An edge that is part of a feature, or of the boundary. Line 0: one of a component that could
  /// not be remeshed, all of whose edges stay.
  struct LineEdge
  {
    std::array<Index, 2> Ends;
    Index Line;
  };

  std::vector<Vector3> Points;
  std::vector<Vertex> Vertices;
  Faces Cells;
  std::vector<LineEdge> LineEdges;
};
}

#endif
