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
/// Joins triangles in pairs, the nearest ones first: two triangles and the k quads of a strip
/// between them, which crosses no line, become k + 1 quads. Often each edge of the strip moves on
/// to the next vertex on one side, which changes the valence of few vertices. Faces are to stay
/// good. Takes time in proportion to the faces that are nearer to a triangle than the one it is
/// joined with. Throws Stopped.
/// @param atAnyPrice where no strip leaves faces good they become as good as they can, and vertices
///                   may become irregular; only triangles that find no other one stay. Otherwise
///                   triangles whose join gains nothing stay, too.
void JoinTriangles(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, bool atAnyPrice, const Progress& progress = {});
}

#endif
