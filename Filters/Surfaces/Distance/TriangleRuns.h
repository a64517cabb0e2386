// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TriangleRuns_h
#define DirectionFields_TriangleRuns_h

#include "Distance/ClosestPoints.h"
#include "Support/LargeArray.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Finds the closest points of a surface for a few places: boxes around runs of triangles that
/// follow each other in a given order. They are made in the time that it takes to read the
/// triangles; each search looks at all boxes. Eight places on 40 000 to 330 000 triangles take 0.2
/// % of the time of a smoothest field on them, ClosestPoints 6 to 9 %, because it sorts and copies
/// the triangles first: an edit of singularities would take 10 to 15 % longer.
class TriangleRuns
{
public:
  /// @param surface must outlive this
  /// @param order   the triangles to be found, whose corners are points with finite coordinates;
  ///                such that neighbours in the order are near each other, as in a mesh
  TriangleRuns(const Surface& surface, LargeArray<Index>&& order);

  /// The closest point of all triangles, of equally close ones that of the first triangle of the
  /// surface.
  ClosestPoints::Answer Find(const Vector3& place) const;

private:
  static constexpr Index RunSize = 64;
  struct Box
  {
    Vector3 Low;
    Vector3 High;
  };

  const Surface& Input;
  LargeArray<Index> Order;
  std::vector<Box> Boxes;
  /// A power of two, so that squares neither overflow nor vanish.
  double Scale = 1.0;
};
}

#endif
