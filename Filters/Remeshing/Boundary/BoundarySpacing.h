// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundarySpacing_h
#define DirectionFields_BoundarySpacing_h

#include "Types.h"

namespace DirectionFields
{
/// Where the vertices on the boundary of a mesh are, that is, on edges of one triangle only.
enum class BoundarySpacing
{
  /// Where the faces are best.
  Free = 0,
  /// At the same distances between two corners, or around; with sizes relative to these.
  Even = 1,
  /// At the points that the boundary of the surface has, and nowhere else: meshes on both sides of
  /// it fit. Faces beside it are as large as its edges, and grow or shrink from there to the wanted
  /// size.
  Keep = 2
};

/// What the boundary of a mesh is like.
struct BoundaryFigures
{
  /// The points of the surface's boundary; 0 with BoundarySpacing::Free.
  Index Points = 0;
  /// With BoundarySpacing::Keep: those of them that are vertices of the mesh's boundary, exactly,
  /// and its vertices that are none of them.
  Index Kept = 0;
  Index Others = 0;
  /// With BoundarySpacing::Even: the standard deviation of the lengths of edges, relative to their
  /// mean and the sizes, between those two corners where it is largest.
  double Unevenness = 0.0;
};
}

#endif
