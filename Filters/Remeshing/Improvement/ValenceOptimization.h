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
/// Looks for a few edits of quads, one after the other, around each irregular vertex and triangle that leave fewer of
/// them, and does them where the faces stay as good as they were, after their vertices have moved (the operations of
/// M. Tarini, N. Pietroni, P. Cignoni, D. Panozzo, E. Puppo: Practical quad mesh simplification, 2010). Vertices and
/// edges on features and the boundary stay, and so do vertices whose number of faces their singularity explains.
/// Takes time in proportion to the irregular vertices. Throws Stopped.
void OptimizeValences(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, const Progress& progress = {});
}

#endif
