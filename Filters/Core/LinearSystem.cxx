// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LinearSystem.h"

#include "Factorization.h"
#include "SmallestEigenpair.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
/// Refinement goes on until the relative residual is below this, or no longer falls.
constexpr double WantedResidual = 1e-12;
constexpr int MaximumRefinements = 30;
/// Where the right-hand side is smaller than this part of ‖|K| |u|‖, the residual is measured by
/// that: rounding of K u alone would exceed any residual relative to a tiny right-hand side.
constexpr double RoundingScale = 1e-6;
/// Added to the diagonal, relative to it, where a matrix is singular up to rounding.
constexpr double Regularizations[] = { 0.0, 1e-14, 1e-12, 1e-10, 1e-8 };

/// Solves by a factor and refines with the matrix itself: what the factor loses to rounding or to
/// regularization comes back.
SystemSolution Solve(const SparseMatrix& matrix, const ComplexVector& b)
{
  SystemSolution solution;
  solution.Vector = ComplexVector::Zero(b.size());
  const double size = b.norm();
  if (!(size > 0.0))
  {
    return solution;
  }
  Factorization factor;
  bool factored = false;
  for (const double regularization : Regularizations)
  {
    SparseMatrix regular = matrix;
    regular.diagonal() *= 1.0 + regularization;
    factored = factor.Compute(regular);
    if (factored)
    {
      break;
    }
  }
  if (!factored)
  {
    throw std::runtime_error("The linear system could not be factored: the mesh has triangles of too "
                             "different sizes or shapes. Remesh it more evenly.");
  }
  ComplexVector residual = b;
  solution.Residual = 1.0;
  for (int step = 0; step < MaximumRefinements && solution.Residual > WantedResidual; ++step)
  {
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

SystemSolution SolveAligned(const SparseMatrix& matrix, const ComplexVector& rightHandSide)
{
  return Solve(matrix, rightHandSide);
}

SystemSolution SolveConstrainedEnergy(
  const SparseMatrix& matrix, const ComplexVector& rightHandSide, const GivenValues& given)
{
  const Split split(matrix, given);
  const ComplexVector right = MovedToTheRight(matrix, rightHandSide, given);
  ComplexVector freeRight(static_cast<Eigen::Index>(split.Free.size()));
  for (std::size_t k = 0; k < split.Free.size(); ++k)
  {
    freeRight[static_cast<Eigen::Index>(k)] = right[split.Free[k]];
  }
  return Joined(Solve(split.FreeColumns(matrix, true), freeRight), split, given);
}

SystemSolution SolveConstrainedLeastSquares(
  const SparseMatrix& matrix, const ComplexVector& rightHandSide, const GivenValues& given)
{
  const Split split(matrix, given);
  const SparseMatrix columns = split.FreeColumns(matrix, false);
  const SparseMatrix adjoint = columns.adjoint();
  const SparseMatrix normal = adjoint * columns;
  return Joined(
    Solve(normal, adjoint * MovedToTheRight(matrix, rightHandSide, given)), split, given);
}
}
