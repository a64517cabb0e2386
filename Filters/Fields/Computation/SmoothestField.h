// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SmoothestField_h
#define DirectionFields_SmoothestField_h

#include "Eigenpairs/Eigenpair.h"
#include "Multigrid/Hierarchy.h"
#include "Multigrid/SectionBlock.h"
#include "Options.h"

#include <functional>
#include <memory>

namespace DirectionFields::Internal
{
/// Hierarchy and eigenvalue that a component's smallest eigenpair leaves for other systems with its
/// matrices.
struct SmallestPairs
{
  Eigenpair First;
  Solver SolverUsed = Solver::Direct;
  /// Null unless SolverUsed is Multigrid.
  std::unique_ptr<DirectionFields::Hierarchy> Hierarchy;
  /// Approximations of the smallest eigenvectors, orthonormal in M to some digits; the first of
  /// them is that of First, apart from its phase. Empty where there is no hierarchy.
  LowestSections Lowest;
};

/// Finds the smallest eigenpair by the solver that is asked for. Throws Stopped.
/// @param start    makes the section that the direct solver begins with
/// @param progress is told before each V-cycle or solve how far the solver is
SmallestPairs FindSmallestPairs(const Operators& operators,
  const std::function<ComplexVector()>& start, Solver solver, const EigenpairSettings& settings,
  const Progress& progress);
}

#endif
