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
/// Repairs faces that smoothing cannot make better (with a scaled Jacobian below 0.3): all of their
/// vertices are on features or the boundary, or they have too many or too few faces. Of all edits
/// around such a face, and of some pairs of edits, it applies the one that leaves the best faces
/// after their vertices have moved; irregular vertices and triangles count against an edit. Takes
/// time in proportion to the bad faces; where there are many only the worst are treated. Throws
/// Stopped.
/// @param mayMakeTriangles whether quads may become triangles
/// @param degree           4 for quads, 6 for triangles
void RepairQuality(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, bool mayMakeTriangles, int degree = 4,
  const Progress& progress = {});
}

#endif
