// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EvenStreamlines_h
#define DirectionFields_EvenStreamlines_h

#include "Progress.h"
#include "Streamlines/SpacedLine.h"
#include "Streamlines/TracedStreamline.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Streamlines that cover a component of the surface evenly, each family by itself: where two of
/// one family run beside each other, their distance is about the spacing.
///
/// B. Jobard, W. Lefer: Creating Evenly-Spaced Streamlines of Arbitrary Density, 1997, on a surface
/// and for n directions. The first streamlines start where |u| is largest, because the directions
/// are most certain there. Each streamline has seeds on both sides, at the distance of the spacing
/// along the surface. When no seeds are left, the other places follow in the order of |u|, so that
/// no gap remains. A streamline runs in both directions until it is too close to another one of its
/// family or to itself, comes back to its start, or ends by itself.
///
/// The streamlines beside all those at hand are traced at once, on the threads of the scope, and
/// taken in their order; parts that are too close to those taken before are cut off. Hence the
/// streamlines do not depend on the number of threads. As only distances and |u| decide, they turn
/// and grow with the surface.
///
/// Throws Stopped.
/// @param field    its LongestStep is set here
/// @param excluded not 0 for triangles of the mesh without seeds; empty for none
std::vector<TracedStreamline> TraceEvenStreamlines(const GivenField& field,
  const SingularPoints& zeros, Index component, const EvenOptions& options,
  const std::vector<char>& excluded, const Progress& progress);
}

#endif
