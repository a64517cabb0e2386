// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundarySides_h
#define DirectionFields_BoundarySides_h

#include "Boundary/BoundaryLine.h"
#include "FaceMesh/FaceMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A path of a mesh's boundary and the line of the surface that it is on.
struct BoundarySide
{
  Index Line = None;
  /// In the order of the line. Of closed ones the first vertex is there again at the end.
  std::vector<Index> Vertices;
  /// Where they are on the line. Of closed lines the first one is in the first round, and the last
  /// one a whole round later.
  std::vector<double> Places;
};

/// Pairs the boundary of a mesh with that of its surface: each path of the mesh's has the line that
/// the middles of most of its edges are on. Paths whose line others have, too, or which are closed
/// where that is open, have no side.
std::vector<BoundarySide> BoundarySidesOf(
  const FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines);
}

#endif
