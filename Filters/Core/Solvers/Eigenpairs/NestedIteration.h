// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NestedIteration_h
#define DirectionFields_NestedIteration_h

#include "Solvers/Multigrid/Cycle.h"
#include "Solvers/Multigrid/SectionBlock.h"

#include <functional>

namespace DirectionFields
{
/// Approximations of the four smallest eigenpairs of A u = lambda M u on the finest level.
struct NestedPairs
{
  /// Without Energy.
  SectionBlock Block;
  /// Ascending. Empty where the iteration broke down.
  Eigen::VectorXd Values;
};

/// The smallest pairs of the coarsest level, improved on each finer one by a few steps of the
/// locally optimal block preconditioned conjugate gradient method (A. Knyazev, SIAM J. Sci. Comput.
/// 23, 2001) with V-cycles; by as few as will do on the finest.
/// @param goOn called before each step; false stops with Values empty
NestedPairs IterateNested(const Operators& operators, const Hierarchy& hierarchy,
  const Cycle& cycle, const std::function<bool()>& goOn);
}

#endif
