// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NarrowCorners_h
#define DirectionFields_NarrowCorners_h

#include "Charts/FeatureLines.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Edges of features that leave a vertex along the same line of a map as another feature next to them: those
/// that meet at an angle of less than half of 2 pi / n. A map would have no room between the two. Of the two the
/// one on the shorter chain is named, the boundary never, from the vertex on to where there is room for an edge
/// of the lattice.
/// @param perLength 1 / h of each vertex of the mesh, h the wanted length of an edge
std::vector<Index> EdgesInNarrowCorners(const SurfaceGeometry& geometry,
  const TriangleMesh::Component& component, const FieldMatching& charts,
  const FeatureLines& features, const std::vector<char>& isFrameless,
  const std::vector<double>& perLength);
}

#endif
