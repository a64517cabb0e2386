// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConjugateGradients_h
#define DirectionFields_ConjugateGradients_h

#include "Solvers/Systems/MultigridSystem.h"

namespace DirectionFields
{
/// Steps go on until the residual that they keep is below this part of the tolerance, and start again
/// from the true residual while that is above the tolerance.
constexpr double ResidualMargin = 0.9;
constexpr int MostSteps = 300;
constexpr int MostRestarts = 4;

/// K u = b by conjugate gradients, preconditioned by V-cycles and what they lack of the inverse on the
/// lowest sections. Returns zero with the residual 1 where there are no V-cycles.
/// @param lowest as for MultigridSystem::Solve, or null
/// @param solved where to begin; gets the solution
SystemSolution ConjugateGradients(const MultigridSystem& system, const Hierarchy& hierarchy,
  const LowestSections* lowest, const ComplexVector& b, ReducedBasis& solved);
}

#endif
