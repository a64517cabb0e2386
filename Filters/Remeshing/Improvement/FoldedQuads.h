// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FoldedQuads_h
#define DirectionFields_FoldedQuads_h

#include "FaceMesh/Faces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Cuts quads that are folded, or concave, into two triangles each, along the diagonal that leaves them flatter:
/// where the map is bad no smoothing may have unfolded them. The first triangle takes the place of the quad, the
/// others come last. A diagonal that is an edge already is not taken. Returns how many quads were cut.
Index CutFoldedQuads(Faces& faces, const std::vector<Vector3>& points);
}

#endif
