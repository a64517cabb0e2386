// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ComponentField_h
#define DirectionFields_ComponentField_h

#include "Result.h"
#include "Field/SmoothestField.h"
#include "Solvers/Systems/FreeSystem.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace DirectionFields
{
/// What the guidance contributes to the systems of a component, for any strength.
struct GuidanceTerms
{
  /// What they were made of.
  ComplexVector Guidance;
  std::vector<Index> GivenVertices;
  /// M q of the scaled guidance; empty where nothing is left of it.
  ComplexVector MassTimes;
  /// Of the component.
  double Area = 0.0;
};

/// The field of one component. All matrices and vectors are over its vertices.
struct ComponentProblem
{
  const Operators& Matrices;
  const SmallestPairs& Smoothest;
  /// Of the constraints last solved for, or null; kept for the next time.
  std::unique_ptr<FreeSystem>& Free;
  /// Of the solutions so far, without constraints.
  ReducedBasis& Solved;
  /// Of the last call; kept for the next.
  std::optional<GuidanceTerms>& Terms;
  /// sigma of Options::AlignmentStrength, in 1 / Metric::Unit^2, but for lambda_1.
  double Scale;
  /// Metric::Unit.
  double Unit;
  /// What the field is drawn to; empty for nothing.
  ComplexVector Guidance;
  GivenValues Given;
  /// Called before each step of an iterative solver; false makes it return early.
  std::function<bool()> GoOn;
};

/// A linear system counts as solved up to this relative residual, the eigenvalue problem's as far as
/// rounding allows.
inline double SystemTolerance(const Options& options)
{
  return std::max(1e-8, options.Tolerance);
}

/// Solves (A - lambda_t M) u = (lambda_1 - lambda_t) alpha M q with alpha = 0 at constrained vertices
/// and their neighbours, else 1, and q scaled to modulus 1 in the mean square over where alpha is 1:
/// u tends to q where lambda_t tends to minus infinity, and guidance and constraints are of one
/// size. lambda_t = 0 where there are constraints only. Without either the smoothest field. Where
/// lambda_1 was overestimated, as by a section that has not converged, lambda_t is as much less as
/// makes the system definite.
/// The field is scaled to modulus 1 in the mean square over the component.
/// Fills in Lambda, SmoothnessEnergy, SystemResidual and SolverUsed of the report.
ComplexVector SolveComponent(
  const ComponentProblem& problem, const Options& options, ComponentReport& report);
}

#endif
