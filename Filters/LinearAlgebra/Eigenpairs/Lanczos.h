// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Lanczos_h
#define DirectionFields_Lanczos_h

#include "Eigenpairs/Eigenpair.h"

namespace DirectionFields::Internal
{
/// The smallest eigenpair by the shift-and-invert Lanczos iteration in the inner product of M,
/// fully orthogonalized and thickly restarted (K. Wu and H. Simon, SIAM J. Matrix Anal. Appl. 22,
/// 2000); by a dense solver for small matrices. Where the eigenspace has several dimensions the
/// result is the start's projection on it. Where the iteration has not converged after
/// MaximumIterations, the result is the best pair so far, its Residual above Tolerance. Throws
/// std::runtime_error if no factor is found, and Stopped.
/// @param start    must not be orthogonal to the eigenspace
/// @param progress is told before each solve how far the iteration is
Eigenpair SolveByLanczos(const SparseMatrix& energy, const SparseMatrix& mass,
  const ComplexVector& start, const EigenpairSettings& settings, const Progress& progress = {});
}

#endif
