// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConnectedTriangles_h
#define DirectionFields_ConnectedTriangles_h

#include "Support/LargeArray.h"
#include "Types.h"

namespace DirectionFields::Internal
{
/// The connected components of triangles, numbered by their first triangles.
struct ConnectedTriangles
{
  /// @param twins the other side of each half-edge, three of each triangle, or None
  explicit ConnectedTriangles(const LargeArray<Index>& twins);

  /// The component of each triangle.
  LargeArray<Index> Component;
  Index Count = 0;
};
}

#endif
