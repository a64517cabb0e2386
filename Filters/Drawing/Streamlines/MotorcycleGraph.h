// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MotorcycleGraph_h
#define DirectionFields_MotorcycleGraph_h

#include "Progress.h"
#include "Streamlines/TracedStreamline.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The graph of a component's field, also known as motorcycle graph (Eppstein, Goodrich, Kim, Tamstorf:
/// Motorcycle Graphs: Canonical Quad Mesh Partitioning, 2008): the lines out of all singularities set out
/// at once and at the same speed, and where one comes to the trail of another one, or to its own, it ends.
/// What they enclose are the patches of the field: for n = 4 on a closed surface these are quads, with
/// corners at the singularities and where lines end.
///
/// A line that runs into another singularity along one of that one's own rays (within rounding, as on
/// symmetric surfaces) is the line from there, too: the two meet in the middle and are one edge, if
/// nothing stops them before.
///
/// With S singularities, N lines of this graph and the Euler characteristic chi there are chi + N - S
/// patches on a closed surface, if all of these are disks.
///
/// Lines are traced in rounds of doubled length, on the threads of the scope, and meetings found among the
/// pieces in each triangle. Throws Stopped.
/// @param rays       of the singularities of one component, in the order of these
/// @param mostLength in the unit of the component
std::vector<TracedStreamline> TraceMotorcycleGraph(const TracedField& field,
  const std::vector<ZeroRay>& rays, double mostLength, const Progress& progress);
}

#endif
