// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/DirectSystem.h"

#include "Solvers/Matrices/Factorization.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/SparseProducts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
/// Refinement goes on until the relative residual is below this, or no longer falls.
constexpr double WantedResidual = 1e-12;
constexpr int MaximumRefinements = 30;
/// A sum below this part of the sum of its terms' magnitudes is nothing but rounding.
constexpr double Cancelled = 1e-15;
/// Conjugate gradient steps until the squared gradient has fallen by so much, and how often they
/// start again.
constexpr double StepReduction = 1e-24;
constexpr int MaximumSteps = 1000;
constexpr int MaximumRestarts = 5;
/// A least squares solution with a larger residual is tried once more by another way, unless that
/// would couple an unknown with more others than this in the mean.
constexpr double AcceptedResidual = 1e-9;
constexpr double DensestCouplings = 30.0;
/// Where the right-hand side is smaller than this part of ‖|K| |u|‖, the residual is measured by
/// that: rounding of K u alone would exceed any residual relative to a tiny right-hand side.
constexpr double RoundingScale = 1e-6;
/// Added to the diagonal, relative to it, where a matrix is singular up to rounding.
constexpr double Regularizations[] = { 0.0, 1e-14, 1e-12, 1e-10, 1e-8 };

/// Finite, and how large.
double CheckedNorm(const ComplexVector& rightHandSide)
{
  const double norm = rightHandSide.norm();
  if (!std::isfinite(norm))
  {
    throw std::runtime_error("The right-hand side of the linear system is not finite.");
  }
  return norm;
}

/// Throws Stopped.
void RequireToGoOn(const GoOnFunction& goOn)
{
  if (goOn && !goOn())
  {
    throw Stopped();
  }
}

/// Factors a matrix, with a little added to its diagonal where it needs that.
void Factor(const SparseMatrix& matrix, const GoOnFunction& goOn, Factorization& factor)
{
  for (const double regularization : Regularizations)
  {
    SparseMatrix regular = matrix;
    regular.diagonal() *= 1.0 + regularization;
    const ProgressFunction ask =
      goOn ? ProgressFunction([&](double) { return goOn(); }) : ProgressFunction();
    if (factor.Compute(regular, Progress(ask)))
    {
      return;
    }
  }
  throw NotPositiveDefinite();
}

/// Solves by a factor and refines with the matrix itself: what the factor loses to rounding or to
/// regularization comes back.
SystemSolution Solve(const SparseMatrix& matrix, const ComplexVector& b, const GoOnFunction& goOn)
{
  SystemSolution solution;
  solution.Vector = ComplexVector::Zero(b.size());
  const double size = CheckedNorm(b);
  if (size == 0.0)
  {
    return solution;
  }
  Factorization factor;
  Factor(matrix, goOn, factor);
  ComplexVector residual = b;
  solution.Residual = 1.0;
  for (int step = 0; step < MaximumRefinements && solution.Residual > WantedResidual; ++step)
  {
    RequireToGoOn(goOn);
    const ComplexVector better = solution.Vector + factor.Solve(residual);
    const ComplexVector rest = b - matrix * better;
    const double relative =
      rest.norm() / std::max(size, RoundingScale * SumOfMagnitudes(matrix, better));
    if (!(relative < solution.Residual))
    {
      break;
    }
    const bool stalls = relative > 0.5 * solution.Residual;
    solution.Vector = better;
    solution.Residual = relative;
    residual = rest;
    if (stalls)
    {
      break;
    }
  }
  return solution;
}

/// Minimizes ‖K_f u - b‖ by conjugate gradients on K_f K_ff^-1 (CGLS, Björck 1996), where the rows of
/// the free vertices are the identity and only the others are left to deal with.
SystemSolution SolveByFactoredSquare(const SparseMatrix& columns, const SparseMatrix& adjoint,
  const SparseMatrix& square, const ComplexVector& b, const GoOnFunction& goOn)
{
  SystemSolution solution;
  solution.Vector = ComplexVector::Zero(columns.cols());
  const double size = CheckedNorm(adjoint * b);
  const double terms = SumOfMagnitudes(adjoint, b);
  if (size <= Cancelled * terms)
  {
    return solution;
  }
  Factorization factor;
  Factor(square, goOn, factor);
  solution.Residual = 1.0;
  // Starting again from the true residual takes back what rounding adds up in the recursions.
  for (int start = 0; start < MaximumRestarts && solution.Residual > WantedResidual; ++start)
  {
    ComplexVector u = solution.Vector;
    ComplexVector r = b - columns * u;
    ComplexVector s = factor.Solve(adjoint * r);
    ComplexVector p = s;
    double gamma = s.squaredNorm();
    const double first = gamma;
    for (int step = 0; step < MaximumSteps && gamma > StepReduction * first; ++step)
    {
      RequireToGoOn(goOn);
      const ComplexVector direction = factor.Solve(p);
      const ComplexVector q = columns * direction;
      const double alpha = gamma / q.squaredNorm();
      if (!std::isfinite(alpha))
      {
        break;
      }
      u += alpha * direction;
      r -= alpha * q;
      s = factor.Solve(adjoint * r);
      const double next = s.squaredNorm();
      p = s + (next / gamma) * p;
      gamma = next;
    }
    const double rounding = SumOfMagnitudes(adjoint, columns.cwiseAbs() * u.cwiseAbs());
    const double relative =
      (adjoint * (b - columns * u)).norm() / std::max(size, RoundingScale * (terms + rounding));
    if (!(relative < solution.Residual))
    {
      break;
    }
    const bool stalls = relative > 0.5 * solution.Residual;
    solution.Vector = u;
    solution.Residual = relative;
    if (stalls)
    {
      break;
    }
  }
  return solution;
}

/// Minimizes ‖K_f u - b‖: by a factor of K_f^* K_f unless that is dense, as at a vertex of many
/// triangles, or too badly conditioned.
SystemSolution SolveLeastSquares(const SparseMatrix& columns, const SparseMatrix& square,
  const ComplexVector& b, const GoOnFunction& goOn)
{
  const SparseMatrix adjoint = columns.adjoint();
  SystemSolution solution;
  solution.Residual = std::numeric_limits<double>::infinity();
  if (IsNormalMatrixSparse(adjoint, DensestCouplings))
  {
    RequireToGoOn(goOn);
    solution = Solve(adjoint * columns, adjoint * b, goOn);
  }
  if (solution.Residual > AcceptedResidual)
  {
    SystemSolution other = SolveByFactoredSquare(columns, adjoint, square, b, goOn);
    if (other.Residual < solution.Residual)
    {
      return other;
    }
  }
  return solution;
}

/// b - K_c u_c
ComplexVector MovedToTheRight(const SparseMatrix& matrix, const ComplexVector& b,
  const FreeVertices& free, const GivenValues& given)
{
  return b - matrix * free.Scattered(given);
}
}

SystemSolution SolveDirectly(
  const SparseMatrix& matrix, const ComplexVector& rightHandSide, const GoOnFunction& goOn)
{
  return Solve(matrix, rightHandSide, goOn);
}

SystemSolution MinimizeEnergyDirectly(const SparseMatrix& matrix, const ComplexVector& rightHandSide,
  const GivenValues& given, const GoOnFunction& goOn)
{
  const FreeVertices free(given.Vertices, static_cast<Index>(matrix.cols()));
  SystemSolution solution = Solve(free.Principal(matrix),
    free.Gathered(MovedToTheRight(matrix, rightHandSide, free, given)), goOn);
  solution.Vector = free.Joined(solution.Vector, given);
  return solution;
}

SystemSolution MinimizeResidualDirectly(const SparseMatrix& matrix, const ComplexVector& rightHandSide,
  const GivenValues& given, const GoOnFunction& goOn)
{
  const FreeVertices free(given.Vertices, static_cast<Index>(matrix.cols()));
  SystemSolution solution = SolveLeastSquares(free.Columns(matrix), free.Principal(matrix),
    MovedToTheRight(matrix, rightHandSide, free, given), goOn);
  solution.Vector = free.Joined(solution.Vector, given);
  return solution;
}
}
