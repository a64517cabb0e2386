// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef AcrossSolution_h
#define AcrossSolution_h

#include "Components/ProcessGroups.h"
#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Options.h"
#include "Result.h"
#include "Solver/DistributedGuide.h"
#include "Solver/PetscObjects.h"

#include <functional>
#include <vector>

namespace DirectionFields::Parallel
{
/// Solves for a component that lies across the processes of a group, all of which call it. Throws
/// Stopped and std::runtime_error on all of them, and as DoOnAll does.
/// @param members of the group
/// @param goOn    as in DistributedSettings
/// @param rowOf   as in AssembleMatrices
/// @param section over the vertices of the mesh; gets the values of the owned ones
/// @return whether other fields are as smooth as this one, and nothing has chosen among them
bool SolveAcross(const Messages& members, const ProcessGroups::Group& group,
  const DistributedMesh& mesh, const DistributedGuide& guide, const Options& options,
  const std::function<bool(double)>& goOn, std::vector<PetscInt>& rowOf,
  std::vector<Complex>& section, ComponentReport& report);
}

#endif
