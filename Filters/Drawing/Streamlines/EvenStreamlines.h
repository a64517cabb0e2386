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
/// Lines that cover a component of the surface evenly, each family by itself: where two lines of one
/// family run beside each other, they are about the spacing apart.
///
/// B. Jobard, W. Lefer: Creating Evenly-Spaced Streamlines of Arbitrary Density, 1997, on a surface and for
/// n directions. The first lines start where |u| is largest, where the directions are most certain; each
/// line has seeds on both sides of it, at the distance of the spacing along the surface; and where no seed
/// is left, the other places follow, by |u|, so that no gap remains. A line runs both ways until it comes
/// too close to another one of its family or to itself, comes back to its start, or ends by itself.
///
/// The lines beside all lines at hand are traced at once, on the threads of the scope, and taken in their
/// order; what has come too close meanwhile is cut off. Hence the lines do not depend on the number of
/// threads, and as all is done by distances and |u|, they turn and grow with the surface.
///
/// Throws Stopped.
/// @param field    its LongestStep is set here
/// @param excluded not 0 for triangles of the mesh without seeds; empty for none
std::vector<TracedStreamline> TraceEvenStreamlines(const GivenField& field,
  const SingularPoints& zeros, Index component, const EvenOptions& options,
  const std::vector<char>& excluded, const Progress& progress);
}

#endif
