// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ComponentField_h
#define DirectionFields_ComponentField_h

#include "LinearSystem.h"
#include "Operators.h"
#include "Options.h"
#include "Result.h"
#include "SmallestEigenpair.h"
#include "TangentFrames.h"

#include <vector>

namespace DirectionFields
{
/// The user's vectors as a section of degree n over the vertices of the mesh: the n-th power of the
/// projected vector's direction times its length times its weight.
std::vector<Complex> GuidanceSection(
  const TriangleMesh& mesh, const TangentFrames& frames, const Guidance& guidance, int degree);

/// The Hopf differential as a section of degree 2, towards the larger curvature or the smaller, or
/// its square, of degree 4.
std::vector<Complex> CurvatureSection(
  const std::vector<Complex>& hopf, int degree, CurvatureDirection direction);

/// The field of one component. All matrices and vectors are over its vertices.
struct ComponentProblem
{
  const Operators& Matrices;
  const Eigenpair& Smoothest;
  /// sigma of Options::AlignmentStrength, in 1 / Metric::Unit^2, but for lambda_1.
  double Scale;
  /// Metric::Unit.
  double Unit;
  /// What the field is drawn to; empty for nothing.
  ComplexVector Guidance;
  GivenValues Given;
};

/// Solves (A - lambda_t M) u = (lambda_1 - lambda_t) alpha M q with alpha = 0 at constrained vertices
/// and their neighbours, else 1, and q scaled to modulus 1 in the mean square over where alpha is 1:
/// u tends to q where lambda_t tends to minus infinity, and guidance and constraints are of one
/// size. lambda_t = 0 where there are constraints only. Without either the smoothest field.
/// The field is scaled to modulus 1 in the mean square over the component.
/// Fills in Lambda, SmoothnessEnergy and SystemResidual of the report.
ComplexVector SolveComponent(
  const ComponentProblem& problem, const Options& options, ComponentReport& report);
}

#endif
