// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LeastSquares_h
#define DirectionFields_LeastSquares_h

#include "Solvers/Systems/FreeSystem.h"

namespace DirectionFields::Internal
{
/// Solves K_f^* K_f u_f = K_f^* (b - K_c u_c), K_f and K_c the columns of the free and of the given
/// vertices, by conjugate gradients on the normal equations (CGLS, Björck 1996) with
/// LeastSquaresPreconditioner: u minimizes ‖K u - b‖ among the sections with the given values (POC14).
/// @param freeSystem that of the system's matrices and of the given vertices
SystemSolution MinimizeResidualByMultigrid(const ShiftedSystem& system,
  const FreeSystem& freeSystem, const ComplexVector& rightHandSide, const GivenValues& given);
}

#endif
