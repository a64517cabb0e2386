// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PhaseSmoothing_h
#define DirectionFields_PhaseSmoothing_h

#include "Progress.h"
#include "Stripes/WantedPhases.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves the phases of a component such that the sum over its edges of the squared differences
/// between steps and wanted steps, weighted by cotangents, is as small as can be while the steps
/// keep their whole cycles, and hence the stripes their branch points: the best pattern of that
/// topology, by one linear system. Throws Stopped.
/// @param phases over all nodes, in cycles; replaced at the nodes of the component
void SmoothPhases(const WantedPhases& wanted, const WantedPhases::Component& component,
  const Progress& progress, std::vector<double>& phases);
}

#endif
