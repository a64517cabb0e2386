// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MultigridEigenpair_h
#define DirectionFields_MultigridEigenpair_h

#include "Multigrid.h"
#include "Options.h"
#include "SectionBlock.h"
#include "SmallestEigenpair.h"

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
  std::unique_ptr<Multigrid> Hierarchy;
  /// Approximations of the smallest eigenvectors, orthonormal in M to some digits, the first of them
  /// First but for its phase.
  /// Empty where there is no hierarchy.
  LowestSections Lowest;
};

/// The smallest eigenpair of A u = lambda M u by multigrid: the smallest few pairs of the coarsest
/// level are improved from level to level; on the finest level the smallest one converges by
/// Jacobi-Davidson steps (G. Sleijpen and H. van der Vorst, SIAM J. Matrix Anal. Appl. 17, 1996),
/// whose correction equation is solved in single precision by conjugate gradients with V-cycles, the
/// next pairs deflated. Where that is slow, since the next eigenvalues are near, the steps are kept:
/// the space of all of them has Ritz vectors for each. Residuals are in double precision.
///
/// Iterations counts V-cycles on the finest level after the nested iteration. Where the iteration
/// stalls or they are used up: the best pair so far, its Residual above Tolerance.
/// @param lowest   filled in as in SmallestPairs
/// @param progress called before each V-cycle with the number done; false stops
Eigenpair SmallestEigenpair(const Operators& operators, const Multigrid& hierarchy,
  const EigenpairSettings& settings, const std::function<bool(int)>& progress,
  LowestSections& lowest);

/// By the solver that is asked for.
/// @param start    of the direct solver
/// @param progress as above; Aborted of the first pair says that it stopped
SmallestPairs FindSmallestPairs(const Operators& operators,
  const std::function<ComplexVector()>& start, Solver solver, const EigenpairSettings& settings,
  const std::function<bool(int)>& progress);
}

#endif
