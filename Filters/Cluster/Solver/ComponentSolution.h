// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ComponentSolution_h
#define ComponentSolution_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Options.h"
#include "Processes.h"
#include "Result.h"
#include "Solver/DistributedGuide.h"

#include <functional>
#include <vector>

namespace DirectionFields::Parallel
{
/// The fields of all components of the whole surface. All processes call it; throws ProcessesError.
/// @param goOn    as in ComputeDistributed
/// @param reports one for each component, without the counts
/// @return the section, over the vertices of the mesh; right at vertices that belong to the piece
/// or are next to it
std::vector<Complex> SolveDistributed(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const DistributedGuide& guide, const Options& options,
  const std::function<bool(double)>& goOn, std::vector<ComponentReport>& reports);
}

#endif
