// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShiftedSystem_h
#define DirectionFields_ShiftedSystem_h

#include "Progress.h"
#include "Solvers/Matrices/Operators.h"
#include "Types.h"

namespace DirectionFields::Internal
{
/// The matrix K = a A + m M of one component, a >= 0, and how far systems with it are to be solved. What
/// the iterative solvers return may have a Residual above the Tolerance where V-cycles do not help. They
/// throw Stopped.
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
  /// Whether systems with other factors are to follow: the first solution then takes longer, and they
  /// take fewer steps.
  bool OthersFollow = false;

  /// m / a, within the range of the hierarchy.
  double Shift() const;
  /// K x
  ComplexVector Times(const ComplexVector& x) const;
};
}

#endif
