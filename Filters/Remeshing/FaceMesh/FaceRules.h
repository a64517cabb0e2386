// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceRules_h
#define DirectionFields_FaceRules_h

#include "FaceMesh/FaceEdits.h"
#include "FaceMesh/MovableFaces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The wanted number of faces at each vertex, and the edits that are allowed there: inside four, or
/// six of triangles alone, unless a singularity of the field explains another number; on lines the
/// number for which there is room in each sector between them.
/// @param degree 4 for quads, 6 for triangles
std::vector<FaceEdits::Rule> RulesFor(const VertexStars& faces, const MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, int degree = 4);

/// The same rules, but vertices whose number of faces a singularity explains may have others.
std::vector<FaceEdits::Rule> WithoutLocks(std::vector<FaceEdits::Rule> rules);

/// Marks the vertices whose edits would change faces at a hub.
std::vector<char> FindVerticesNearHubs(const VertexStars& faces, const MovableFaces& places);
}

#endif
