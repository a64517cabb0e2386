// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DeflatedGradients_h
#define DirectionFields_DeflatedGradients_h

#include "Eigenpairs/Eigenpair.h"
#include "Matrices/OperatorProducts.h"
#include "Multigrid/Cycle.h"
#include "Multigrid/SectionBlock.h"

namespace DirectionFields::Internal
{
/// b = value M u - A u of a section u, which is not stored: it would be as large as the section.
struct ResidualOfSection
{
  const SectionProducts& Section;
  double Value;
  /// ‖b‖
  double Norm;

  Index Rows() const { return static_cast<Index>(this->Section.Vector.size()); }
  Complex operator[](Index v) const
  {
    return this->Value * this->Section.Mass[v] - this->Section.Energy[v];
  }
};

/// Conjugate gradients with V-cycles in single precision that leave out a few sections V: they
/// solve P^* K P t = P^* b, where K = A + shift m, m is the lumped mass and P = 1 - V (W^* V)^-1
/// W^*. A column of W is K times one of V, which leaves it out without an error (Nicolaides 1987),
/// or m times it where K nearly vanishes on it.
class DeflatedGradients
{
public:
  /// The level, the cycle and the block must outlive the object. The block may change between
  /// solves; of it count the vectors V and their energy products, except those of the first
  /// section. Sections that are zero deflate nothing.
  DeflatedGradients(
    const Hierarchy::Level& finest, const Cycle& cycle, const SectionBlock& deflated);

  struct Outcome
  {
    int Steps = 0;
    /// The matrix turned out not to be positive definite: the solution is a section t with t^* K t
    /// <= 0.
    bool Indefinite = false;
  };

  /// Takes steps until the norm of the residual has fallen by the reduction, which is below 1, or
  /// the most steps have been taken. Throws Stopped.
  /// @param cycles counts a V-cycle for each step
  Outcome Solve(const ResidualOfSection& rightHandSide, double shift, double reduction,
    int mostSteps, SolveCounter& cycles, ComplexVector& solution);

private:
  /// Fills in W and the inverses.
  void Prepare(double shift);
  /// t = 0, r = P^* b / ‖b‖; returns ‖r‖^2. With a residual of unit length nothing leaves the range
  /// of single precision.
  double Begin(const ResidualOfSection& rightHandSide);
  /// z = P B r for the V-cycle B; returns Re r^* z.
  double Precondition();
  /// p = z + keep p
  void Turn(float keep);
  /// q = K p; returns p^* K p.
  /// @param along becomes V^* q
  double Multiply(double shift, Eigen::Vector4cd& along);
  /// t += step p, r -= step P^* q; returns ‖r‖^2.
  /// @param along V^* q
  double Advance(float step, const Eigen::Vector4cd& along);

  const Hierarchy::Level& Finest;
  const Cycle& Preconditioner;
  /// The work of a step (see WorkLimit).
  const double StepWork;
  const SectionBlock& Deflated;
  /// W; empty between solves, when the iteration needs most memory.
  CompactSections Tested;
  /// (W^* V)^-1 and its adjoint.
  Eigen::Matrix4cd Inverse;
  Eigen::Matrix4cd InverseAdjoint;
  /// t, r, p, z and q, in this order.
  CompactSections Solution;
  CompactSections Residual;
  CompactSections Direction;
  CompactSections Preconditioned;
  CompactSections Product;
};
}

#endif
