// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FreeSystem_h
#define DirectionFields_FreeSystem_h

#include "Matrices/FreeVertices.h"
#include "Multigrid/Hierarchy.h"
#include "Systems/ReducedBasis.h"
#include "Systems/ShiftedSystem.h"
#include "Systems/SystemSolution.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The matrices among the vertices whose values are not given, and the hierarchy of these matrices.
struct FreeSystem
{
  /// @param scale as in Hierarchy
  FreeSystem(const Operators& operators, const std::vector<Index>& given, double scale);

  std::vector<Index> Given;
  FreeVertices Free;
  Operators Matrices;
  DirectionFields::Hierarchy Hierarchy;
  /// Spanned by the solutions of MinimizeEnergyByMultigrid so far.
  ReducedBasis Solved;
};

/// Solves K_ff u_f = b_f - K_fc u_c by conjugate gradients with V-cycles, in time linear in the
/// vertices: u minimizes u^* K u - 2 Re b^* u among the sections with the given values.
/// @param freeSystem that of the system's matrices and of the given vertices; gets the solution for
///                   its basis
SystemSolution MinimizeEnergyByMultigrid(const ShiftedSystem& system, FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given);
}

#endif
