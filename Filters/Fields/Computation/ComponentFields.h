// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ComponentFields_h
#define DirectionFields_ComponentFields_h

#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Progress.h"
#include "Result.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The fields of all components.
struct ComponentFields
{
  /// The section, over the vertices of the mesh.
  std::vector<Complex> Section;
  /// The solvers' part of each component's report; the counts are not filled in.
  std::vector<ComponentReport> Reports;
};

/// Solves for one component after the other. Throws Stopped.
/// @param energy         of the same stages
/// @param phaseReference a section that smoothest fields are turned towards, which leave one
///                       rotation of each component open; where it is empty, fields of unit
///                       length are turned towards the shape of the component
/// @param othersFollow   as in ComponentStage
ComponentFields SolveComponents(Stages& stages, EnergyStage& energy, const Guide& guide,
  const std::vector<Complex>& phaseReference, const Options& options, bool othersFollow,
  const Progress& progress);
}

#endif
