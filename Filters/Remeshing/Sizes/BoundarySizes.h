// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundarySizes_h
#define DirectionFields_BoundarySizes_h

#include "Boundary/BoundaryLine.h"
#include "Surface.h"

#include <functional>
#include <vector>

namespace DirectionFields::Internal
{
/// Lengths that are those of the boundary's own edges there and grow or shrink to the wanted ones
/// by no more than a slope over the distance along edges.
/// @param wanted at the points of the surface
std::vector<double> LengthsFromBoundary(const Surface& surface,
  const std::vector<BoundaryLine>& lines, std::vector<double> wanted, double slope);

/// The lengths of edges at the points of a surface whose boundary keeps its own edges: wanted sizes
/// times a length for which there are as many faces as without, as far as the boundary lets that
/// be. Empty where the boundary's edges have the wanted lengths, but for a quarter.
/// @param sizes      wanted at the points, above 0
/// @param edgeLength where the size is 1
/// @param isFixed    whether that stays as it is, whatever the number of faces
std::vector<double> LengthsForBoundary(
  const Surface& surface, const std::vector<double>& sizes, double edgeLength, bool isFixed);
}

#endif
