// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/LinearSystem.h"

#include "Solvers/Matrices/Factorization.h"
#include "Solvers/Matrices/OperatorProducts.h"

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

/// Factors a matrix, with a little added to its diagonal where it needs that.
void Factor(const SparseMatrix& matrix, const GoOnFunction& goOn, Factorization& factor)
{
  for (const double regularization : Regularizations)
  {
    SparseMatrix regular = matrix;
    regular.diagonal() *= 1.0 + regularization;
    if (factor.Compute(regular, goOn))
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

/// The rows of K_f are the columns of its adjoint; each couples all its unknowns with each other.
bool IsNormalMatrixSparse(const SparseMatrix& adjoint)
{
  double couplings = 0.0;
  for (Eigen::Index row = 0; row < adjoint.outerSize(); ++row)
  {
    const double unknowns = adjoint.outerIndexPtr()[row + 1] - adjoint.outerIndexPtr()[row];
    couplings += unknowns * unknowns;
  }
  return couplings <= DensestCouplings * static_cast<double>(adjoint.nonZeros());
}

/// Minimizes ‖K_f u - b‖ by conjugate gradients on K_f K_ff^-1 (CGLS, Björck 1996), where the rows of
/// the free vertices are the identity and only the others are left to deal with.
SystemSolution ConjugateGradients(const SparseMatrix& columns, const SparseMatrix& adjoint,
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
  if (IsNormalMatrixSparse(adjoint))
  {
    RequireToGoOn(goOn);
    solution = Solve(adjoint * columns, adjoint * b, goOn);
  }
  if (solution.Residual > AcceptedResidual)
  {
    SystemSolution other = ConjugateGradients(columns, adjoint, square, b, goOn);
    if (other.Residual < solution.Residual)
    {
      return other;
    }
  }
  return solution;
}

/// The free vertices and the matrix' columns of them and of the given ones.
struct Split
{
  Split(const SparseMatrix& matrix, const GivenValues& given)
    : Number(matrix.cols(), None)
  {
    std::vector<char> isGiven(matrix.cols(), 0);
    for (const Index v : given.Vertices)
    {
      isGiven[v] = 1;
    }
    for (Index v = 0; v < matrix.cols(); ++v)
    {
      if (!isGiven[v])
      {
        this->Number[v] = static_cast<Index>(this->Free.size());
        this->Free.push_back(v);
      }
    }
  }

  SparseMatrix FreeColumns(const SparseMatrix& matrix, bool freeRowsOnly) const
  {
    const auto n = static_cast<Index>(this->Free.size());
    SparseMatrix columns(freeRowsOnly ? n : static_cast<Index>(matrix.rows()), n);
    columns.reserve(matrix.nonZeros());
    for (Index k = 0; k < n; ++k)
    {
      columns.startVec(k);
      for (SparseMatrix::InnerIterator it(matrix, this->Free[k]); it; ++it)
      {
        const Index row = freeRowsOnly ? this->Number[it.row()] : static_cast<Index>(it.row());
        if (row != None)
        {
          columns.insertBack(row, k) = it.value();
        }
      }
    }
    columns.finalize();
    return columns;
  }

  std::vector<Index> Free;
  /// Number of each vertex among the free ones; None if given.
  std::vector<Index> Number;
};

/// b - K_c u_c
ComplexVector MovedToTheRight(
  const SparseMatrix& matrix, const ComplexVector& b, const GivenValues& given)
{
  ComplexVector u = ComplexVector::Zero(b.size());
  for (std::size_t k = 0; k < given.Vertices.size(); ++k)
  {
    u[given.Vertices[k]] = given.Values[static_cast<Eigen::Index>(k)];
  }
  return b - matrix * u;
}

SystemSolution Joined(const SystemSolution& free, const Split& split, const GivenValues& given)
{
  SystemSolution solution;
  solution.Residual = free.Residual;
  solution.Vector.resize(static_cast<Eigen::Index>(split.Number.size()));
  for (std::size_t k = 0; k < split.Free.size(); ++k)
  {
    solution.Vector[split.Free[k]] = free.Vector[static_cast<Eigen::Index>(k)];
  }
  for (std::size_t k = 0; k < given.Vertices.size(); ++k)
  {
    solution.Vector[given.Vertices[k]] = given.Values[static_cast<Eigen::Index>(k)];
  }
  return solution;
}
}

SystemSolution SolveAligned(
  const SparseMatrix& matrix, const ComplexVector& rightHandSide, const GoOnFunction& goOn)
{
  return Solve(matrix, rightHandSide, goOn);
}

SystemSolution SolveConstrainedEnergy(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const GoOnFunction& goOn)
{
  const Split split(matrix, given);
  const ComplexVector right = MovedToTheRight(matrix, rightHandSide, given);
  ComplexVector freeRight(static_cast<Eigen::Index>(split.Free.size()));
  for (std::size_t k = 0; k < split.Free.size(); ++k)
  {
    freeRight[static_cast<Eigen::Index>(k)] = right[split.Free[k]];
  }
  return Joined(Solve(split.FreeColumns(matrix, true), freeRight, goOn), split, given);
}

SystemSolution SolveConstrainedLeastSquares(const SparseMatrix& matrix,
  const ComplexVector& rightHandSide, const GivenValues& given, const GoOnFunction& goOn)
{
  const Split split(matrix, given);
  return Joined(SolveLeastSquares(split.FreeColumns(matrix, false), split.FreeColumns(matrix, true),
                  MovedToTheRight(matrix, rightHandSide, given), goOn),
    split, given);
}
}
