// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConeTree_h
#define DirectionFields_ConeTree_h

#include "Charts/CutMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A cone, and the jump of the path that leads from it towards the root of a tree of all cones;
/// None at a root.
struct TreeCone
{
  Index Cone;
  Index Jump;
};

/// The cones of a mesh as a tree of the fewest paths from its root, which is the boundary, or the
/// first cone where no path ends at a boundary: each cone comes before the one that it leads to.
std::vector<TreeCone> LeavesFirst(const CutMesh& mesh);
}

#endif
