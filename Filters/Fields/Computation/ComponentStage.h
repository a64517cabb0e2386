// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ComponentStage_h
#define DirectionFields_ComponentStage_h

#include "Computation/SmoothestField.h"
#include "Computation/SystemFactors.h"
#include "Guidance/GuidanceTerms.h"
#include "Progress.h"
#include "Result.h"
#include "Systems/FreeSystem.h"
#include "Systems/SystemSolution.h"

#include <memory>
#include <optional>

namespace DirectionFields::Internal
{
/// One component: its matrices and smallest eigenpairs, and the factors and bases that earlier
/// solves leave for the next ones. All matrices and vectors are over the component's vertices.
class ComponentStage
{
public:
  /// @param scale the order of magnitude of the smallest eigenvalue, in 1 / unit^2: with the
  ///              smallest eigenvalue it makes the sigma of Options::AlignmentStrength
  /// @param unit  Metric::Unit of the component
  ComponentStage(Operators matrices, SmallestPairs smoothest, double scale, double unit);

  const Operators& GetMatrices() const { return this->Matrices; }

  /// Whether fields of other strengths are likely to follow. The first aligned one then takes a
  /// twentieth longer, and the next ones a fifth less; none of them changes.
  void SetOthersFollow(bool follow) { this->OthersFollow = follow; }

  /// Solves (A + W - lambda_t M) u = (lambda_1 - lambda_t) alpha M q + W g, W and g of SoftTerms,
  /// alpha = 0 at constrained vertices and neighbours, else 1, q scaled to modulus 1 in the mean
  /// square over where alpha is 1: u tends to q as lambda_t to minus infinity; guidance and givens
  /// are of one size. lambda_t = 0 where there are constraints only. Without either the smoothest
  /// field. Where lambda_1 was overestimated, as by a section that has not converged, lambda_t is
  /// as much less as makes the system definite. The field is scaled to modulus 1 in the mean square
  /// over the component. Throws Stopped and NotPositiveDefinite.
  /// @param report   Eigenvalue, Residual, Iterations, Lambda, SmoothnessEnergy, SystemResidual,
  ///                 SolverUsed and Converged are filled in
  /// @param progress asked before each step of an iterative solver
  ComplexVector Solve(const ComponentGuide& guide, const Options& options, const Progress& progress,
    ComponentReport& report);

  /// The hierarchy of the matrices, made if there was none.
  const Hierarchy& GetHierarchy();
  /// The system of the vertices whose values are not given, soft constraints in its energy, kept
  /// from one call to the next with the same ones.
  FreeSystem& FreeSystemOf(const ComponentGuide& guide);
  /// The terms of soft constraints, or null for none, kept likewise.
  const SoftTerms* SoftTermsOf(const ComponentGuide& guide);
  /// A value in 1 / unit^2 in 1 / length^2 of the input.
  double PerArea(double value) const;
  /// sigma of Options::AlignmentStrength, in 1 / unit^2.
  double Sigma() const;
  /// lambda_1 - lambda_t, 0 to infinity. It is no less than the error of lambda_1, since
  /// A - lambda_t M could be indefinite otherwise.
  /// @param share of the strength, 0 to 1
  double Gap(const Options& options, double share) const;

private:
  /// The terms of the guide, made anew where it has changed.
  const GuidanceTerms& TermsOf(const ComponentGuide& guide);
  /// Smaller gaps give the smoothest field: the guidance's part would be below rounding.
  double SmallestGap() const;
  /// The smoothest field, in the phase that is closest to the guidance.
  ComplexVector SmoothestTowards(const GuidanceTerms& terms) const;
  /// The aligned or constrained field. The gap grows where the system turns out to be indefinite.
  SystemSolution SolveAt(double gap, const ComponentGuide& guide, const GuidanceTerms& terms,
    const Options& options, const Progress& progress, ComponentReport& report);
  SystemSolution SolveSystem(const SystemFactors& factors, const ComponentGuide& guide,
    const ComplexVector& rightHandSide, const Options& options, const Progress& progress,
    ComponentReport& report);
  SystemSolution SolveByMultigrid(const SystemFactors& factors, const ComponentGuide& guide,
    const ComplexVector& rightHandSide, const Options& options, const Progress& progress);
  SystemSolution SolveByFactor(const SystemFactors& factors, const ComponentGuide& guide,
    const ComplexVector& rightHandSide, const Options& options, const Progress& progress);
  /// Scales the solution and fills in the figures of the report.
  ComplexVector Finish(
    SystemSolution solution, double area, const Options& options, ComponentReport& report) const;

  Operators Matrices;
  SmallestPairs Smoothest;
  /// The hierarchy where the smallest eigenpair was found without one.
  std::unique_ptr<Hierarchy> OwnHierarchy;
  double Scale;
  double Unit;
  /// The system of the vertices that the last constraints left free; null before there were any.
  std::unique_ptr<FreeSystem> Free;
  /// Null without soft constraints; those of the matrices that Free is of.
  std::unique_ptr<SoftTerms> Soft;
  /// The solutions without constraints, from which the next one is guessed.
  ReducedBasis Solved;
  std::optional<GuidanceTerms> Terms;
  bool OthersFollow = false;
};
}

#endif
