// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DeflatedGradients_h
#define DirectionFields_DeflatedGradients_h

#include "Solvers/Multigrid/Cycle.h"
#include "Solvers/Multigrid/SectionBlock.h"

#include <functional>

namespace DirectionFields
{
/// Conjugate gradients with V-cycles in single precision, beside a few sections V that are left out:
/// solves P^* K P t = P^* r, K = A + shift m, m the lumped mass, P = 1 - V (W^* V)^-1 W^*. A column of
/// W is K times one of V, which leaves it out without an error (Nicolaides 1987), or m times it where
/// K nearly vanishes.
class DeflatedGradients
{
public:
  /// All must outlive the object. Of the block, which may change between solves, the vectors and
  /// their energy products count; those of the first section are not needed. Sections that are zero
  /// deflate nothing.
  DeflatedGradients(const Hierarchy::Level& finest, const Cycle& cycle, const SectionBlock& deflated);

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
  /// W and the inverse.
  void Prepare(double shift);

  const Hierarchy::Level& Finest;
  const Cycle& Preconditioner;
  const SectionBlock& Deflated;
  /// W.
  CompactSections Tested;
  /// The inverse of W^* V.
  Eigen::Matrix4cd Inverse;
  CompactSections Solution;
  CompactSections Residual;
  CompactSections Direction;
  CompactSections Preconditioned;
  CompactSections Product;
};
}

#endif
