// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundaryDistance_h
#define DirectionFields_BoundaryDistance_h

#include "Boundary/BoundaryLine.h"
#include "FaceMesh/Faces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The largest distance of places on the boundary of a surface from that of a mesh of it, and of
/// places on that of the mesh from the surface's. A slit that faces close, or a notch that they
/// cover, is nowhere far from the mesh, but its edges are far from the mesh's boundary. 0 where one
/// of the two has none.
/// @param lines of the surface's boundary
/// @param step  length between places on an edge, above 0
double BoundaryDistance(const std::vector<BoundaryLine>& lines, const std::vector<Vector3>& points,
  const Faces& faces, double step);
}

#endif
