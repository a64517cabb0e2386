// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SmoothestField_h
#define DirectionFields_SmoothestField_h

#include "Options.h"
#include "Solvers/Eigenpairs/MultigridEigenpair.h"

#include <functional>
#include <memory>

namespace DirectionFields
{
/// What the smallest eigenpair of a component leaves for other systems with its matrices.
struct SmallestPairs
{
  Eigenpair First;
  Solver SolverUsed = Solver::Direct;
  /// Only where SolverUsed is Multigrid.
  std::unique_ptr<DirectionFields::Hierarchy> Hierarchy;
  /// Approximations of the smallest eigenvectors, orthonormal in M to some digits, the first of them
  /// First but for its phase.
  /// Empty where there is no hierarchy.
  LowestSections Lowest;
};

/// By the solver that is asked for.
/// @param start    of the direct solver
/// @param progress called before each V-cycle or solve with the number done; false stops. Aborted of the first pair says that it stopped
SmallestPairs FindSmallestPairs(const Operators& operators,
  const std::function<ComplexVector()>& start, Solver solver, const EigenpairSettings& settings,
  const std::function<bool(int)>& progress);
}

#endif
