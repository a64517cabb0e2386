// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NarrowCorners_h
#define DirectionFields_NarrowCorners_h

#include "Charts/FeatureLines.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Feature edges that leave a vertex along the same line of a map as the neighbouring feature: the
/// two meet at an angle of less than half of 2 pi / n, and a map would have no room between them.
/// The feature of the shorter chain is named, never the boundary, from the vertex to where there is
/// room for an edge of the grid.
/// @param perLength 1 / h of each vertex of the mesh, h the wanted length of an edge
std::vector<Index> EdgesInNarrowCorners(const SurfaceGeometry& geometry,
  const TriangleMesh::Component& component, const FieldMatching& matching,
  const FeatureLines& features, const std::vector<char>& isFrameless,
  const std::vector<double>& perLength);
}

#endif
