// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ValenceOptimization_h
#define DirectionFields_ValenceOptimization_h

#include "FaceMesh/MovableFaces.h"
#include "FaceMesh/VertexStars.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Searches, around each irregular vertex and triangle, for a short sequence of edits that leaves
/// fewer of them, and applies it where the faces stay as good as before after their vertices have
/// moved (the operations of M. Tarini, N. Pietroni, P. Cignoni, D. Panozzo, E. Puppo: Practical
/// quad mesh simplification, 2010). Vertices and edges on features and the boundary stay, and so do
/// vertices whose valence their singularity explains. Takes time in proportion to the irregular
/// vertices. Throws Stopped.
void OptimizeValences(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, int degree = 4, const Progress& progress = {});
}

#endif
