// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MergePoints_h
#define DirectionFields_MergePoints_h

#include "Mesh/TriangleMesh.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// For each point the first one that a triangle uses and that has exactly the same coordinates:
/// itself where there is none before it, and where no triangle uses it. 0 and -0 are the same, NaN
/// is not the same as anything. It takes linear time, except where hashing has very bad luck.
std::vector<Index> FirstAtSamePlace(const Surface& surface);

/// The triangles with the first of their points at the same place; the points stay, so that their
/// ids do.
Surface Merged(const Surface& surface, const std::vector<Index>& first);

/// Points on the boundary of a mesh, and how many of them lie exactly on another of them.
struct BoundaryPoints
{
  BoundaryPoints(const TriangleMesh& mesh, const std::vector<Vector3>& points);

  /// At least half of them coincide: the surface falls into pieces that only look connected.
  bool LookLikeSoup() const
  {
    return this->Coincident > 0 && this->Coincident >= this->Count - this->Coincident;
  }

  Index Count = 0;
  Index Coincident = 0;
};
}

#endif
