// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MultigridEigenpair_h
#define DirectionFields_MultigridEigenpair_h

#include "Solvers/Eigenpairs/SmallestEigenpair.h"
#include "Solvers/Multigrid/Hierarchy.h"
#include "Solvers/Multigrid/SectionBlock.h"

#include <functional>

namespace DirectionFields
{
/// The smallest eigenpair of A u = lambda M u by multigrid: the smallest few pairs of the coarsest
/// level are improved from level to level; on the finest level the smallest one converges by
/// Jacobi-Davidson steps (G. Sleijpen and H. van der Vorst, SIAM J. Matrix Anal. Appl. 17, 1996),
/// whose correction equation is solved in single precision by conjugate gradients with V-cycles, the
/// next pairs deflated. Where that is slow, since the next eigenvalues are near, the steps are kept:
/// the space of all of them has Ritz vectors for each. Residuals are in double precision.
///
/// Iterations counts V-cycles on the finest level after the nested iteration. Where the iteration
/// stalls or they are used up: the best pair so far, its Residual above Tolerance.
/// @param lowest   approximations of the smallest eigenvectors are written to it, orthonormal in M to some digits,
///                 the first of them the result but for its phase
/// @param progress called before each V-cycle with the number done; false stops
Eigenpair SmallestEigenpair(const Operators& operators, const Hierarchy& hierarchy,
  const EigenpairSettings& settings, const std::function<bool(int)>& progress,
  LowestSections& lowest);
}

#endif
