// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RowEdits_h
#define DirectionFields_RowEdits_h

#include "Dislocations/EdgeLoops.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Two rows of quads that are put in along a chain of edges, or the two beside it that are taken
/// out. Where the rows begin or end inside of the surface there is a pair of vertices of three and
/// five faces, the corners of one quad that are not neighbours.
struct RowEdit
{
  bool Inserts = true;
  /// The half-edges of the chain whose vertices are divided, or merged with those beside them, and
  /// those that lead there from where the rows begin and on to where they end.
  std::vector<Index> HalfEdges;
  /// Whether the first and the last vertex are of the boundary, where the rows go on to it.
  bool BeginsAtBoundary = false;
  bool EndsAtBoundary = false;
};

/// Whether the vertices beside one of a chain may become one with it.
/// @param h a half-edge of the chain at the vertex
bool MayMerge(const EdgeLoops& chains, const FaceMesh& mesh, Index h, Index v);

/// Edits a mesh. No two edits may have a face in common.
void Apply(const std::vector<RowEdit>& edits, const EdgeLoops& chains, FaceMesh& mesh);
}

#endif
