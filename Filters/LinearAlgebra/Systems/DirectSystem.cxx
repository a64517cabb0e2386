// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/DirectSystem.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/SparseProducts.h"
#include "SparseCholesky/SupernodalCholesky.h"
#include "Systems/ConjugateGradientLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Refinement ends where the relative residual is below this, or no longer falls.
constexpr double WantedResidual = 1e-12;
constexpr int MaximumRefinements = 30;
/// A sum below this part of the sum of its terms' magnitudes is nothing but rounding.
constexpr double Cancelled = 1e-15;
/// Conjugate gradients end where the squared gradient has fallen to this part, or after this number
/// of steps, and start again as often as this.
constexpr double StepReduction = 1e-24;
constexpr int MaximumSteps = 1000;
constexpr int MaximumRestarts = 5;
/// A least squares solution with a larger residual is tried once more by conjugate gradients. They
/// are tried at once where the normal matrix would couple an unknown with more others than this in
/// the mean.
constexpr double AcceptedResidual = 1e-9;
constexpr double DensestCouplings = 30.0;
/// Where the right-hand side is smaller than this part of ‖|K| |u|‖, the residual is measured by
/// that part: rounding of K u alone would exceed any residual relative to a tiny right-hand side.
constexpr double RoundingScale = 1e-6;
/// Parts of the diagonal that are added to it, one after the other, until a matrix that is singular
/// up to rounding can be factored.
constexpr double Regularizations[] = { 0.0, 1e-14, 1e-12, 1e-10, 1e-8 };

/// The norm of a right-hand side, which must be finite.
double CheckedNorm(const ComplexVector& rightHandSide)
{
  const double norm = rightHandSide.norm();
  if (!std::isfinite(norm))
  {
    throw std::runtime_error("The right-hand side of the linear system is not finite.");
  }
  return norm;
}

/// Factors a matrix, with a little added to its diagonal where it needs that.
void Factor(const SparseMatrix& matrix, const Progress& progress, ComplexCholesky& factor)
{
  for (const double regularization : Regularizations)
  {
    SparseMatrix regular = matrix;
    regular.diagonal() *= 1.0 + regularization;
    if (factor.Compute(regular, progress))
    {
      return;
    }
  }
  throw NotPositiveDefinite();
}

/// Solves by a factor and refines the solution with the matrix itself, which restores the digits
/// that the factor loses to rounding or to regularization.
SystemSolution SolveByFactor(
  const SparseMatrix& matrix, const ComplexVector& b, const Progress& progress)
{
  SystemSolution solution;
  solution.Vector = ComplexVector::Zero(b.size());
  const double size = CheckedNorm(b);
  if (size == 0.0)
  {
    return solution;
  }
  ComplexCholesky factor;
  Factor(matrix, progress, factor);
  ComplexVector residual = b;
  solution.Residual = 1.0;
  for (int step = 0; step < MaximumRefinements && solution.Residual > WantedResidual; ++step)
  {
    progress.RequireToGoOn();
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

/// K_f, its adjoint, and the part K_ff of it.
struct FreeColumns
{
  FreeColumns(const SparseMatrix& matrix, const FreeVertices& free)
    : Columns(free.Columns(matrix))
    , Adjoint(this->Columns.adjoint())
    , Square(free.Principal(matrix))
  {
  }

  SparseMatrix Columns;
  SparseMatrix Adjoint;
  SparseMatrix Square;
};

/// Conjugate gradients for ‖K_f u - b‖ on K_f K_ff^-1 (CGLS, Björck 1996), where the rows of the
/// free vertices are the identity and only the others are left to deal with.
class FactoredIteration
{
public:
  /// @param factor of K_ff
  FactoredIteration(const FreeColumns& matrix, const ComplexCholesky& factor,
    const ComplexVector& b, const Progress& progress, ComplexVector u)
    : Matrix(matrix)
    , Factor(factor)
    , Listener(progress)
    , Solution(std::move(u))
    , Residual(b - matrix.Columns * this->Solution)
    , Direction(ComplexVector::Zero(this->Solution.size()))
  {
    this->FindGradient();
    this->SmallSquares = StepReduction * this->Squares;
  }

  bool GoesOn() const
  {
    if (!(this->Squares > this->SmallSquares) || this->Steps >= MaximumSteps)
    {
      return false;
    }
    this->Listener.RequireToGoOn();
    return true;
  }
  double Precondition() const { return this->Squares; }
  void SetDirection(double keep) { this->Direction = this->Gradient + keep * this->Direction; }
  double FindCurvature()
  {
    this->Step = this->Factor.Solve(this->Direction);
    this->Product = this->Matrix.Columns * this->Step;
    return this->Product.squaredNorm();
  }
  void Advance(double step)
  {
    this->Solution += step * this->Step;
    this->Residual -= step * this->Product;
    this->FindGradient();
    ++this->Steps;
  }
  const ComplexVector& GetSolution() const { return this->Solution; }

private:
  /// K_ff^-1 K_f^* r and its squared norm.
  void FindGradient()
  {
    this->Gradient = this->Factor.Solve(this->Matrix.Adjoint * this->Residual);
    this->Squares = this->Gradient.squaredNorm();
  }

  const FreeColumns& Matrix;
  const ComplexCholesky& Factor;
  const Progress& Listener;
  ComplexVector Solution;
  ComplexVector Residual;
  ComplexVector Gradient;
  /// K_ff times the direction of the step, the direction itself and its product with K_f
  ComplexVector Direction;
  ComplexVector Step;
  ComplexVector Product;
  double Squares = 0.0;
  double SmallSquares;
  int Steps = 0;
};

/// Minimizes ‖K_f u - b‖ by conjugate gradients with the factor of K_ff. Starting again from the
/// true residual removes the rounding that their recursions accumulate.
SystemSolution SolveByFactoredSquare(
  const FreeColumns& matrix, const ComplexVector& b, const Progress& progress)
{
  SystemSolution solution;
  solution.Vector = ComplexVector::Zero(matrix.Columns.cols());
  const double size = CheckedNorm(matrix.Adjoint * b);
  const double terms = SumOfMagnitudes(matrix.Adjoint, b);
  if (size <= Cancelled * terms)
  {
    return solution;
  }
  ComplexCholesky factor;
  Factor(matrix.Square, progress, factor);
  solution.Residual = 1.0;
  for (int start = 0; start < MaximumRestarts && solution.Residual > WantedResidual; ++start)
  {
    FactoredIteration iteration(matrix, factor, b, progress, solution.Vector);
    TakeConjugateGradientSteps(iteration);
    const ComplexVector& u = iteration.GetSolution();
    const double rounding =
      SumOfMagnitudes(matrix.Adjoint, matrix.Columns.cwiseAbs() * u.cwiseAbs());
    const double relative = (matrix.Adjoint * (b - matrix.Columns * u)).norm() /
      std::max(size, RoundingScale * (terms + rounding));
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
SystemSolution SolveLeastSquares(
  const FreeColumns& matrix, const ComplexVector& b, const Progress& progress)
{
  SystemSolution solution;
  solution.Residual = std::numeric_limits<double>::infinity();
  if (IsNormalMatrixSparse(matrix.Adjoint, DensestCouplings))
  {
    progress.RequireToGoOn();
    solution =
      SolveByFactor(SparseProduct(matrix.Adjoint, matrix.Columns), matrix.Adjoint * b, progress);
  }
  if (solution.Residual > AcceptedResidual)
  {
    SystemSolution other = SolveByFactoredSquare(matrix, b, progress);
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
  const SparseMatrix& matrix, const ComplexVector& rightHandSide, const Progress& progress)
{
  return SolveByFactor(matrix, rightHandSide, progress);
}

SystemSolution MinimizeEnergyDirectly(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const Progress& progress)
{
  const FreeVertices free(given.Vertices, static_cast<Index>(matrix.cols()));
  SystemSolution solution = SolveByFactor(free.Principal(matrix),
    free.Gathered(MovedToTheRight(matrix, rightHandSide, free, given)), progress);
  solution.Vector = free.Joined(solution.Vector, given);
  return solution;
}

SystemSolution MinimizeResidualDirectly(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const Progress& progress)
{
  const FreeVertices free(given.Vertices, static_cast<Index>(matrix.cols()));
  SystemSolution solution = SolveLeastSquares(
    { matrix, free }, MovedToTheRight(matrix, rightHandSide, free, given), progress);
  solution.Vector = free.Joined(solution.Vector, given);
  return solution;
}
}
