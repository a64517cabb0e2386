// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CoveredTriangles_h
#define DirectionFields_CoveredTriangles_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The orientable double cover of components that cannot be oriented: triangles that are seen from
/// both sides.
struct CoveredTriangles
{
  /// Appends the other side of triangles, wound the other way: (a, b, c) gives (a, c, b). An edge
  /// across which the windings agree joins equal sides, any other leads from one side to the other.
  /// Throws std::length_error where there are too many to be numbered.
  /// @param isCovered 1 for triangles that have another side; all of a component or none
  /// @param corners   of the triangles, 3 each
  /// @param twins     of their half-edges
  CoveredTriangles(
    const std::vector<char>& isCovered, LargeArray<Index>& corners, LargeArray<Index>& twins);

  /// The other side of each triangle, or None; and whether the triangle is one that was appended.
  LargeArray<Index> Mirrors;
  std::vector<char> IsBack;
};
}

#endif
