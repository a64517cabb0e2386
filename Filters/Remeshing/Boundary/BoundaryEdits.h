// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundaryEdits_h
#define DirectionFields_BoundaryEdits_h

#include "Boundary/BoundarySides.h"
#include "FaceMesh/FaceMesh.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Makes the points of a surface's boundary those of the mesh's: vertices of its sides move there,
/// those too many are merged with the next ones, and edges are split where points have no vertex,
/// which leaves triangles among quads. They stay in their places until Release. Sides on which that
/// cannot be are left as they are.
void TakeBoundary(FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines);

/// Moves vertices along the boundary so that its edges between two corners, or around, are equally
/// long, or as long relative to the size there.
/// @param sizes at the points of the surface; empty for the same everywhere
/// @param stay  whether they stay in their places until Release
void SpaceBoundary(FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines,
  const std::vector<double>& sizes, bool stay);

/// Lets the vertices that were held move on their lines again.
void Release(FaceMesh& mesh);

/// How many points the boundary of a surface has, how many of them are vertices of a mesh, and how
/// many more its boundary has.
struct BoundaryCount
{
  BoundaryCount(
    const FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines);
  Index Points = 0;
  Index Kept = 0;
  Index Others = 0;
};

/// The largest standard deviation of the lengths of edges between two corners, or around, in units
/// of their mean; lengths count relative to the size there.
double UnevennessOf(const FaceMesh& mesh, const Surface& surface,
  const std::vector<BoundaryLine>& lines, const std::vector<double>& sizes);
}

#endif
