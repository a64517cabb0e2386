// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShiftedSystem_h
#define DirectionFields_ShiftedSystem_h

#include "Solvers/Matrices/Operators.h"
#include "Types.h"

#include <functional>

namespace DirectionFields
{
/// The matrix K = a A + m M of one component, a >= 0, and how far systems with it are to be solved. The
/// iterative solvers may return a solution whose Residual is larger than the Tolerance: where V-cycles do
/// not help, or where GoOn, called before each step, has said false.
struct ShiftedSystem
{
  const Operators& Matrices;
  /// a
  double EnergyFactor;
  /// m
  double MassFactor;
  /// The relative residual up to which a solution counts as one.
  double Tolerance;
  std::function<bool()> GoOn;
  /// Whether others with other factors are to follow: the first solution then takes longer, and they
  /// take fewer steps.
  bool OthersFollow = false;

  /// m / a, within the range of the hierarchy.
  double Shift() const;
  /// K x
  ComplexVector Times(const ComplexVector& x) const;
};
}

#endif
