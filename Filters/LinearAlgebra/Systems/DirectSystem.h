// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DirectSystem_h
#define DirectionFields_DirectSystem_h

#include "Matrices/FreeVertices.h"
#include "Progress.h"
#include "Systems/SystemSolution.h"

namespace DirectionFields::Internal
{
/// Solves K u = b for a Hermitian positive definite K by its Cholesky factor. This and the other
/// functions throw Stopped and NotPositiveDefinite.
SystemSolution SolveDirectly(
  const SparseMatrix& matrix, const ComplexVector& rightHandSide, const Progress& progress = {});

/// Solves K_ff u_f = b_f - K_fc u_c by the factor of K_ff: u minimizes u^* K u - 2 Re b^* u among
/// the sections with the given values.
SystemSolution MinimizeEnergyDirectly(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const Progress& progress = {});

/// Solves K_f^* K_f u_f = K_f^* (b - K_c u_c), K_f and K_c the columns of the free and of the given
/// vertices: u minimizes ‖K u - b‖ among the sections with the given values. That is the way of the
/// paper (POC14), and kept for comparison with it: minimal energy takes less time and memory, and
/// mostly gives fewer singularities.
SystemSolution MinimizeResidualDirectly(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const Progress& progress = {});
}

#endif
