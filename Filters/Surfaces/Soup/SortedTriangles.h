// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SortedTriangles_h
#define DirectionFields_SortedTriangles_h

#include "Support/LargeArray.h"
#include "Surface.h"

namespace DirectionFields::Internal
{
/// The triangles of a surface that have three corners, sorted so that neighbours in space are
/// mostly close in memory, in whatever order they came in.
struct SortedTriangles
{
  /// Throws MeshError for invalid ids and non-finite coordinates.
  explicit SortedTriangles(const Surface& surface);

  /// Leaves out the triangles that are there too often; of several the first in the input stays.
  /// Returns their number.
  Index RemoveDuplicates();

  /// The points that they use, along a Morton curve.
  LargeArray<Index> Points;
  /// Three of each triangle, as positions in Points. The triangles are sorted by their least ones,
  /// those that share it are in the order of the input.
  LargeArray<Index> Corners;
  /// Each triangle's number in the surface.
  LargeArray<Index> Input;
  /// Triangles left out because they use a point twice.
  Index Collapsed = 0;

private:
  /// Sets Corners, Input and Collapsed.
  /// @param vertexOfPoint the position in Points of each point that is used
  void Sort(const Surface& surface, const LargeArray<Index>& vertexOfPoint);
};
}

#endif
