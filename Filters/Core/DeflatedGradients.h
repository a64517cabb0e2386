// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DeflatedGradients_h
#define DirectionFields_DeflatedGradients_h

#include "Multigrid.h"
#include "SectionBlock.h"

#include <functional>

namespace DirectionFields
{
/// Conjugate gradients with V-cycles in single precision, on the sections M-orthogonal to a few
/// others: solves (1 - M V V^*) (A + shift m) (1 - V V^* M) t = (1 - M V V^*) r, m the lumped mass, V
/// the deflated sections, orthonormal in M.
class DeflatedGradients
{
public:
  /// All must outlive the object. Of the block the vectors and their mass products count; sections
  /// that are zero deflate nothing.
  DeflatedGradients(const Multigrid::Level& finest, const Cycle& cycle, const SectionBlock& deflated);

  struct Outcome
  {
    int Steps = 0;
    /// The matrix turned out not to be positive definite: the solution is a section on which it is
    /// not.
    bool Indefinite = false;
    bool Stopped = false;
  };

  /// Until the residual has fallen by the reduction, below 1, but at most that many steps.
  /// @param goOn called before each step; false stops
  Outcome Solve(const ComplexVector& rightHandSide, double shift, double reduction, int mostSteps,
    const std::function<bool()>& goOn, ComplexVector& solution);

private:
  const Multigrid::Level& Finest;
  const Cycle& Preconditioner;
  const SectionBlock& Deflated;
  CompactSections Solution;
  CompactSections Residual;
  CompactSections Direction;
  CompactSections Preconditioned;
  CompactSections Product;
};
}

#endif
