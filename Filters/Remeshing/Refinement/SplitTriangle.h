// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SplitTriangle_h
#define DirectionFields_SplitTriangle_h

#include "Mesh/TriangleMesh.h"

#include <array>
#include <map>
#include <vector>

namespace DirectionFields::Internal
{
/// The points at the ends of a half-edge, the lower one first.
std::array<Index, 2> EndsOf(const TriangleMesh& mesh, Index h);

/// The corners of a triangle and the middles of its edges, in their order around it.
class SplitTriangle
{
public:
  /// @param middles the point in the middle of each edge that is split, by the points at its ends
  SplitTriangle(
    const TriangleMesh& mesh, Index t, const std::map<std::array<Index, 2>, Index>& middles);

  /// Cuts it into triangles with area: the corners between two middles are cut off, which leaves a
  /// triangle, or a quadrangle that starts at a middle.
  void Cut(std::vector<Triangle>& triangles) const;

private:
  std::vector<Index> Points;
  std::vector<char> IsMiddle;
};
}

#endif
