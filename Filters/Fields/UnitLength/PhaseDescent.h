// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PhaseDescent_h
#define DirectionFields_PhaseDescent_h

#include "Matrices/FreeVertices.h"
#include "Multigrid/Hierarchy.h"
#include "Progress.h"
#include "UnitLength/UnitLengthProblem.h"

#include <memory>

namespace DirectionFields::Internal
{
/// Lowers the energy of a section of modulus 1 over a whole component. Each step costs a V-cycle
/// and a product or two.
class PhaseDescent
{
public:
  /// @param hierarchy of the matrices among the free vertices
  /// @param free      the free vertices; null where all are
  PhaseDescent(
    const UnitLengthProblem& problem, const Hierarchy& hierarchy, const FreeVertices* free);

  /// One step of diffusion and projection (Merriman, Bence and Osher; for cross fields Viertel and
  /// Osting, SIAM J. Sci. Comput. 41, 2019): u becomes x / |x| with (K + shift M) x = shift M
  /// u + p, solved for from u by some V-cycles of the smoothness energy.
  void Diffuse(double shift, int cycles, ComplexVector& u) const;

  /// Nonlinear conjugate gradients in the phases, preconditioned by V-cycles; never raises the
  /// energy.
  /// @param shift      of the V-cycles
  /// @param tolerance  steps go on until one lowers the energy by less than this part of it
  /// @return the number of steps
  int Polish(double shift, double tolerance, int mostSteps, const Progress& progress,
    ComplexVector& u) const;

private:
  class Cycles;
  class Iteration;
  const UnitLengthProblem& Problem;
  const Hierarchy& Matrices;
  const FreeVertices* Free;
};
}

#endif
