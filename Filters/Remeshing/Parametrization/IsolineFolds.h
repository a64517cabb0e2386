// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IsolineFolds_h
#define DirectionFields_IsolineFolds_h

#include "Charts/FeatureIsolines.h"
#include "Charts/IntegerGrid.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where a map runs back and forth along a feature, spaces the feature's vertices anew between its lattice
/// points, in proportion to the lengths of its edges. They move along the isoline, so that everything that a
/// map has to satisfy still holds. Returns the stretches whose ends the map has put at the same place or in
/// the wrong order: they stay as they are.
/// @param own    from the chart of each corner's vertex to that of its triangle
/// @param places of each vertex in its own chart
std::vector<FeatureIsoline> UnfoldIsolines(const CutMesh& mesh, const std::vector<Transition>& own,
  const std::vector<FeatureIsoline>& stretches, std::vector<GridPoint>& places);
}

#endif
