// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeatureTurns_h
#define DirectionFields_FeatureTurns_h

#include "Charts/FeatureLines.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Not 0 for the vertices of features, and of the boundary, where the shape requires a vertex of
/// the mesh: where features end or meet, and where they turn sharply, averaged over a length. A map
/// may have its corners elsewhere, too: along a jagged or round boundary it has to turn somewhere.
/// @param length of each vertex, in the input's unit
std::vector<char> FindTurns(
  const SurfaceGeometry& geometry, const FeatureLines& features, const std::vector<double>& length);
}

#endif
