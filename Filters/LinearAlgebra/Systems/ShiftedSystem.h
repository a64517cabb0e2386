// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShiftedSystem_h
#define DirectionFields_ShiftedSystem_h

#include "Matrices/Operators.h"
#include "Matrices/WorkLimit.h"
#include "Progress.h"
#include "Types.h"

namespace DirectionFields::Internal
{
/// The matrix K = a A + m M of one component, a >= 0, and the residual to which systems with it are
/// to be solved. Solutions of the iterative solvers may have a Residual above the Tolerance where
/// V-cycles do not help. The solvers throw Stopped.
struct ShiftedSystem
{
  const Operators& Matrices;
  /// a
  double EnergyFactor;
  /// m
  double MassFactor;
  /// The relative residual up to which a solution counts as one.
  double Tolerance;
  /// Asked before each step whether to go on.
  DirectionFields::Progress Progress;
  /// Whether systems with other factors are to follow: the first solution then takes longer, and
  /// they take fewer steps.
  bool OthersFollow = false;
  /// Ends an iteration where the direct solver takes less work; null for no limit.
  const WorkLimit* Limit = nullptr;

  /// How many solves with a factor a system takes, and the work by the row and solve besides.
  static constexpr int DirectSolves = 3;
  static constexpr double DirectWork = 50.0;

  /// m / a, within the range of the hierarchy.
  double Shift() const;
  /// K x
  ComplexVector Times(const ComplexVector& x) const;
};
}

#endif
