// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IsolineFolds_h
#define DirectionFields_IsolineFolds_h

#include "LatticeMap/ChartedMesh.h"
#include "LatticeMap/Lattice.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where a map runs back and forth along a feature, spaces the feature's vertices anew between its fixed ones,
/// in proportion to the lengths of its edges. They move along the isoline, so that everything that a map
/// has to satisfy still holds. Features whose ends a map has put in the wrong order stay as they are.
/// Returns how many stretches of features were spaced anew.
/// @param own    from the chart of each corner's vertex to that of its triangle
/// @param fixed  not 0 for vertices that are lattice points
/// @param places of each vertex in its own chart
Index UnfoldIsolines(const ChartedMesh& mesh, const std::vector<Transition>& own,
  const std::vector<char>& fixed, std::vector<LatticePoint>& places);
}

#endif
