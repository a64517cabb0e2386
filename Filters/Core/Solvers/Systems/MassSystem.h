// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MassSystem_h
#define DirectionFields_MassSystem_h

#include "Solvers/Matrices/Operators.h"

namespace DirectionFields::Internal
{
/// Solves M x = b for the mass matrix M of one component, to nearly all digits, by conjugate gradients
/// with the diagonal as preconditioner: scaled by its diagonal the mass matrix is well conditioned on any
/// mesh. Some 30 steps are usual.
ComplexVector SolveMass(const Operators& operators, const ComplexVector& b);
}

#endif
