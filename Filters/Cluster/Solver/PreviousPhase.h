// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PreviousPhase_h
#define PreviousPhase_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Processes.h"
#include "Solver/DistributedGuide.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// Turns the smoothest field of each component towards the field of the time step before, as one
/// process does: nothing else fixes its phase, and the series would jump. Fields that something
/// guides or constrains stay as they are, and all of them where any process does not know the step
/// before. All processes call it; throws ProcessesError.
/// @param previous the first directions of that field, of the input's points; empty for none
/// @param section  over the vertices of the mesh
void FollowPrevious(Processes& processes, const Messages& messages, const DistributedMesh& mesh,
  const PieceWithSurroundings& piece, const DistributedGuide& guide, std::vector<Vector3> previous,
  int degree, std::vector<Complex>& section);
}

#endif
