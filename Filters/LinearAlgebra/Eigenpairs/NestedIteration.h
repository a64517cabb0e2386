// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NestedIteration_h
#define DirectionFields_NestedIteration_h

#include "Multigrid/Cycle.h"
#include "Multigrid/SectionBlock.h"
#include "Progress.h"

namespace DirectionFields::Internal
{
/// Approximations of the four smallest eigenpairs of A u = lambda M u on the finest level.
struct NestedPairs
{
  /// Sections and their energy products. Mass is empty.
  SectionBlock Block;
  /// Ascending. Empty where the iteration broke down.
  Eigen::VectorXd Values;
  /// Work of the iteration (see WorkLimit).
  double Work = 0.0;
};

/// The smallest pairs of the coarsest level, improved on each finer one by a few steps of the
/// locally optimal block preconditioned conjugate gradient method (A. Knyazev, SIAM J. Sci. Comput.
/// 23, 2001) with V-cycles; on the finest level the steps are as few as will do. Throws Stopped.
/// @param progress is asked before each step whether to go on
NestedPairs IterateNested(const Operators& operators, const Hierarchy& hierarchy,
  const Cycle& cycle, const Progress& progress);
}

#endif
