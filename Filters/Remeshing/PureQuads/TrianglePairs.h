// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TrianglePairs_h
#define DirectionFields_TrianglePairs_h

#include "FaceMesh/MovableFaces.h"
#include "FaceMesh/VertexStars.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The number of irregular vertices that it may cost to join triangles.
enum class JoinPolicy
{
  /// No irregular vertices; triangles stay otherwise.
  Free,
  /// Two irregular vertices a pair.
  Cheap,
  /// As many as it takes, but triangles stay where faces would become bad.
  Good,
  /// Where no strip leaves faces good they become as good as they can, and vertices may become
  /// irregular; only triangles that find no other one stay.
  AtAnyPrice
};

/// Joins triangles in pairs, the nearest ones first: two triangles and the k quads of a strip
/// between them, which crosses no line, become k + 1 quads. Often each edge of the strip moves on
/// to the next vertex on one side, which changes the valence of few vertices. Or the row of quads
/// beyond an edge of a triangle is taken out, up to the boundary, another triangle or a strip to
/// one: rows go on over lines. Faces are to stay good. Throws Stopped.
void JoinTriangles(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, JoinPolicy policy, const Progress& progress = {});
}

#endif
