// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_JacobiDavidson_h
#define DirectionFields_JacobiDavidson_h

#include "Eigenpairs/Eigenpair.h"
#include "Multigrid/Hierarchy.h"
#include "Multigrid/SectionBlock.h"

namespace DirectionFields::Internal
{
/// The smallest eigenpair of A u = lambda M u by multigrid: the smallest few pairs of the coarsest
/// level are improved from level to level; on the finest level the smallest one converges by
/// Jacobi-Davidson steps (G. Sleijpen and H. van der Vorst, SIAM J. Matrix Anal. Appl. 17, 1996),
/// whose correction equation is solved in single precision by conjugate gradients with V-cycles,
/// the next pairs deflated. Where that is slow, since the next eigenvalues are near, the steps are
/// kept: the space of all of them has Ritz vectors for each. Residuals are in double precision.
///
/// Iterations counts V-cycles on the finest level after the nested iteration. Where the iteration
/// stalls or has used up MaximumIterations, the result is the best pair so far, its Residual above
/// Tolerance. Throws Stopped.
/// @param progress is told before each V-cycle how far the iteration is
/// @param lowest   becomes approximations of the smallest eigenvectors, orthonormal in M to some
///                 digits; the first of them is the result, apart from its phase
Eigenpair SolveByJacobiDavidson(const Operators& operators, const Hierarchy& hierarchy,
  const EigenpairSettings& settings, const Progress& progress, LowestSections& lowest);
}

#endif
