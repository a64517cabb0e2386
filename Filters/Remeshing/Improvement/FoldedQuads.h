// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FoldedQuads_h
#define DirectionFields_FoldedQuads_h

#include "FaceMesh/Faces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Cuts folded and concave quads into two triangles each, along the diagonal that leaves them
/// flatter: where the map is bad, smoothing may not have unfolded them. The first triangle takes
/// the number of the quad, the others come last. A diagonal that is already an edge is not used.
/// Returns the number of quads that were cut.
/// @param quality the scaled Jacobian up to which quads count as folded
Index CutFoldedQuads(Faces& faces, const std::vector<Vector3>& points, double quality = 0.01);
}

#endif
