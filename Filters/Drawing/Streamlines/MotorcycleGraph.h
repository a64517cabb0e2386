// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MotorcycleGraph_h
#define DirectionFields_MotorcycleGraph_h

#include "Progress.h"
#include "Streamlines/TracedStreamline.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The graph of a component's field, also known as motorcycle graph (Eppstein, Goodrich, Kim,
/// Tamstorf: Motorcycle Graphs: Canonical Quad Mesh Partitioning, 2008): the streamlines out of all
/// singularities start at the same time and run at the same speed, and each ends where it meets the
/// trail of another one, or its own. They enclose the patches of the field: for n = 4 on a closed
/// surface these are quads, with corners at the singularities and where streamlines end.
///
/// A streamline that runs into another singularity along one of the rays of that singularity
/// (within rounding, as on symmetric surfaces) is also the streamline from there: the two meet in
/// the middle and are one edge, if nothing stops them before.
///
/// With S singularities, N streamlines of this graph and the Euler characteristic chi there are chi
/// + N - S patches on a closed surface, if all of these are disks.
///
/// Streamlines are traced in rounds of doubled length, on the threads of the scope, and meetings
/// are found among the pieces in each triangle. Throws Stopped.
/// @param rays       of the singularities of one component, in the order of these
/// @param mostLength in the unit of the component
std::vector<TracedStreamline> TraceMotorcycleGraph(const TracedField& field,
  const std::vector<ZeroRay>& rays, double mostLength, const Progress& progress);
}

#endif
