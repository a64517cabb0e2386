// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RegionFigures_h
#define DirectionFields_RegionFigures_h

#include "Types.h"

#include <vector>

namespace DirectionFields
{
/// How well a mesh shows the regions of its surface. Places count as met within a tenth of the
/// wanted length of edges.
struct RegionFigures
{
  Index Regions = 0;
  /// The part, from 0 to 1, of the length of their borders that is on edges between faces of
  /// different regions.
  double BordersKept = 1.0;
  /// The part of that length that runs in stairs along the triangles, and is not kept.
  double Stairs = 0.0;
  /// Places where three regions meet, or two at the boundary, that are no vertices.
  Index MissedCorners = 0;
  /// Of all regions with faces, relative to the area on the surface.
  double LargestAreaError = 0.0;
  /// Those without faces, ascending.
  std::vector<Index> Lost;
};
}

#endif
