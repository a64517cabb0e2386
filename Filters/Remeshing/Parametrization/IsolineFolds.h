// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IsolineFolds_h
#define DirectionFields_IsolineFolds_h

#include "Charts/FeatureIsolines.h"
#include "Charts/IntegerGrid.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where a map runs back and forth along a feature, spaces the feature's vertices anew between its
/// grid points, in proportion to the lengths of its edges. They move along the isoline, so that
/// every constraint of the map still holds. Returns the isolines whose ends the map has put at the
/// same place or in the wrong order; they are left unchanged.
/// @param own    from the chart of each corner's vertex to the chart of its triangle
/// @param places of each vertex in its own chart
std::vector<FeatureIsoline> UnfoldIsolines(const CutMesh& mesh, const std::vector<Transition>& own,
  const std::vector<FeatureIsoline>& isolines, std::vector<GridPoint>& places);
}

#endif
