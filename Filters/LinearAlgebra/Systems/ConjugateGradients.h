// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConjugateGradients_h
#define DirectionFields_ConjugateGradients_h

#include "Multigrid/Hierarchy.h"
#include "Multigrid/SectionBlock.h"
#include "Systems/ReducedBasis.h"
#include "Systems/ShiftedSystem.h"
#include "Systems/SystemSolution.h"

namespace DirectionFields::Internal
{
/// Steps go on until the residual that they keep is below this part of the tolerance, and start
/// again from the true residual while that is above the tolerance.
constexpr double ResidualMargin = 0.9;
constexpr int MostSteps = 300;
constexpr int MostRestarts = 4;

/// Solves K u = b by conjugate gradients, preconditioned by V-cycles and a correction towards the
/// inverse on the lowest sections, in time linear in the vertices. Returns zero with the residual 1
/// where there are no V-cycles.
/// @param lowest approximations of the smallest eigenvectors of A, orthonormal in M, which K may
///               nearly map to zero; or empty
/// @param solved the iteration begins with a guess from this basis, which then gets the solution
SystemSolution ConjugateGradients(const ShiftedSystem& system, const Hierarchy& hierarchy,
  const LowestSections& lowest, const ComplexVector& b, ReducedBasis& solved);
}

#endif
