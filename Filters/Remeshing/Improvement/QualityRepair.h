// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_QualityRepair_h
#define DirectionFields_QualityRepair_h

#include "FaceMesh/MovableFaces.h"
#include "FaceMesh/VertexStars.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Mends faces that no smoothing makes better (a scaled Jacobian below 0.3): all of their vertices are on features or
/// the boundary, or there are too many or too few faces around them. Of all edits of the faces around one, and of some
/// pairs of edits, the one is done that leaves the best faces, after their vertices have moved; irregular vertices and
/// triangles count against it. Takes time in proportion to the bad faces, the worst of which are looked at where they
/// are many. Throws Stopped.
/// @param mayMakeTriangles whether quads may become triangles
void RepairQuality(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, bool mayMakeTriangles,
  const Progress& progress = {});
}

#endif
