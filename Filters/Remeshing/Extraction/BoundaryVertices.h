// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundaryVertices_h
#define DirectionFields_BoundaryVertices_h

#include "Extraction/MeshExtraction.h"

#include <vector>

namespace DirectionFields::Internal
{
/// New vertices on an edge of a component's boundary, which has its face to the left.
struct BoundaryVertices
{
  Index Face;
  Index Tail;
  Index Head;
  std::vector<Vector3> Positions;
  /// The edge's feature.
  Index Line = 0;
};

/// Puts them into a component: a quad with one vertex more becomes a quad and a triangle.
/// @param all at most one for each edge; in any order, which changes
void InsertBoundaryVertices(ExtractedMesh& cells, std::vector<BoundaryVertices>& all);
}

#endif
