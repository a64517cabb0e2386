// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ComponentSolution_h
#define ComponentSolution_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Options.h"
#include "Processes.h"
#include "Result.h"
#include "Solver/DistributedGuide.h"

#include <functional>
#include <vector>

namespace DirectionFields::Parallel
{
/// The fields of all components of the whole surface.
struct DistributedSolution
{
  /// Over the vertices of the mesh; right at vertices that belong to the piece or are next to it.
  std::vector<Complex> Section;
  /// One for each component, without the counts; the same on all processes.
  std::vector<ComponentReport> Reports;
  /// How many components across processes have several fields as smooth as theirs, which nothing
  /// but the smoothness has chosen.
  int Ambiguous = 0;
};

/// All processes call it; throws ProcessesError.
/// @param goOn    as in ComputeDistributed
DistributedSolution SolveDistributed(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const PieceWithSurroundings& piece, const DistributedGuide& guide,
  const Options& options, const std::function<bool(double)>& goOn);
}

#endif
