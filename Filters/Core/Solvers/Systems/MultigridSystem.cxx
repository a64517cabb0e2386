// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/MultigridSystem.h"

#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradients.h"
#include "Solvers/Systems/LeastSquaresPreconditioner.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace DirectionFields
{
namespace
{
/// In 1 / unit^2; above it the mass matrix is all that counts.
constexpr double LargestShift = 1e8;

/// Least squares take as many steps as they need, which on triangles of very different shapes are more
/// the more vertices there are, but end where so many have not halved the gradient.
constexpr int MostLeastSquaresSteps = 1200;
constexpr int MostSlowSteps = 60;

std::vector<Index> Complement(const std::vector<Index>& given, Index count)
{
  std::vector<char> isGiven(count, 0);
  for (const Index v : given)
  {
    isGiven[v] = 1;
  }
  std::vector<Index> others;
  for (Index v = 0; v < count; ++v)
  {
    if (!isGiven[v])
    {
      others.push_back(v);
    }
  }
  return others;
}

/// Rows and columns of the vertices in the list, which ascends.
SparseMatrix Principal(const SparseMatrix& matrix, const std::vector<Index>& vertices)
{
  const auto n = static_cast<Index>(vertices.size());
  std::vector<Index> number(matrix.cols(), None);
  for (Index k = 0; k < n; ++k)
  {
    number[vertices[k]] = k;
  }
  SparseMatrix principal(n, n);
  Index* const begin = principal.outerIndexPtr();
  const auto forEntries = [&](Index k, const auto& body)
  {
    for (SparseMatrix::InnerIterator it(matrix, vertices[k]); it; ++it)
    {
      if (number[it.row()] != None)
      {
        body(number[it.row()], it.value());
      }
    }
  };
  ForRows(vertices,
    [&](Index first, Index last)
    {
      for (Index k = first; k < last; ++k)
      {
        Index count = 0;
        forEntries(k, [&](Index, const Complex&) { ++count; });
        begin[k + 1] = count;
      }
    });
  std::partial_sum(begin, begin + n + 1, begin);
  principal.resizeNonZeros(begin[n]);
  ForRows(vertices,
    [&, rows = principal.innerIndexPtr(), values = principal.valuePtr()](Index first, Index last)
    {
      for (Index k = first; k < last; ++k)
      {
        Index at = begin[k];
        forEntries(k,
          [&](Index row, const Complex& value)
          {
            rows[at] = row;
            values[at++] = value;
          });
      }
    });
  return principal;
}

ComplexVector Gathered(const ComplexVector& all, const std::vector<Index>& vertices)
{
  ComplexVector some(static_cast<Eigen::Index>(vertices.size()));
  ForRows(some,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        some[k] = all[vertices[k]];
      }
    });
  return some;
}

/// Zero elsewhere.
ComplexVector Scattered(
  const ComplexVector& some, const std::vector<Index>& vertices, Eigen::Index count)
{
  ComplexVector all = ComplexVector::Zero(count);
  ForRows(some,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        all[vertices[k]] = some[k];
      }
    });
  return all;
}
}

FreeSystem::FreeSystem(const Operators& operators, const std::vector<Index>& given, double scale)
  : Given(given)
  , Free(Complement(given, static_cast<Index>(operators.Energy.cols())))
  , Matrices([&]
      {
        Operators principal;
        principal.Energy = Principal(operators.Energy, this->Free);
        principal.Mass = Principal(operators.Mass, this->Free);
        return principal;
      }())
  , Hierarchy(this->Matrices, scale, LeftOver::Drop)
{
}

double MultigridSystem::Shift() const
{
  return this->MassFactor < LargestShift * this->EnergyFactor
    ? this->MassFactor / this->EnergyFactor
    : LargestShift;
}

ComplexVector MultigridSystem::Times(const ComplexVector& x) const
{
  return Product(this->Matrices, this->EnergyFactor, this->MassFactor, x);
}

SystemSolution MultigridSystem::Solve(const Hierarchy& hierarchy, const LowestSections& lowest,
  const ComplexVector& rightHandSide, ReducedBasis& solved) const
{
  return ConjugateGradients(*this, hierarchy, &lowest, rightHandSide, solved);
}

SystemSolution MultigridSystem::SolveConstrainedEnergy(FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given) const
{
  const Eigen::Index count = rightHandSide.size();
  SystemSolution solution;
  ComplexVector u = Scattered(given.Values, given.Vertices, count);
  if (freeSystem.Free.empty())
  {
    solution.Vector = std::move(u);
    return solution;
  }
  const ComplexVector b = Gathered(rightHandSide - this->Times(u), freeSystem.Free);
  const MultigridSystem inner{ freeSystem.Matrices, this->EnergyFactor, this->MassFactor,
    this->Tolerance, this->GoOn };
  const SystemSolution free =
    ConjugateGradients(inner, freeSystem.Hierarchy, nullptr, b, freeSystem.Solved);
  solution.Residual = free.Residual;
  u += Scattered(free.Vector, freeSystem.Free, count);
  solution.Vector = std::move(u);
  return solution;
}

/// Conjugate gradients on the normal equations (CGLS, Björck 1996).
SystemSolution MultigridSystem::SolveConstrainedLeastSquares(const FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given) const
{
  SystemSolution solution;
  solution.Vector = Scattered(given.Values, given.Vertices, rightHandSide.size());
  if (freeSystem.Free.empty())
  {
    return solution;
  }
  const CombinedMatrix matrix(this->Matrices, this->EnergyFactor, this->MassFactor);
  ComplexVector q;
  matrix.Multiply(solution.Vector, q);
  const ComplexVector b = rightHandSide - q;
  // The gradient is K_f^* r: K r but at given vertices. Returns its norm.
  const auto findGradient = [&](const ComplexVector& r, ComplexVector& gradient)
  {
    matrix.Multiply(r, gradient);
    for (const Index v : given.Vertices)
    {
      gradient[v] = 0.0;
    }
    return Norm(gradient);
  };
  ComplexVector gradient;
  const double size = findGradient(b, gradient);
  if (!(size > 0.0))
  {
    return solution;
  }
  solution.Residual = 1.0;
  LeastSquaresPreconditioner preconditioner(
    Combined(this->Matrices, this->EnergyFactor, this->MassFactor), freeSystem.Free,
    freeSystem.Hierarchy, std::max(0.0, this->Shift()));
  ComplexVector x = ComplexVector::Zero(b.size());
  int steps = 0;
  for (int restart = 0;
       preconditioner.IsUsable() && restart < MostRestarts && steps < MostLeastSquaresSteps;
       ++restart)
  {
    ComplexVector better = x;
    ComplexVector r;
    matrix.Multiply(better, r);
    r -= b;
    preconditioner.Correct(preconditioner.Deflate(r), better);
    r = -r;
    double slope = findGradient(r, gradient);
    // Of directions, so that nothing leaves the range of single precision.
    const double unit = slope;
    LargeArray<CompactComplex> direction(b.size(), 0.0f);
    // Coefficients of what the direction and the sum of all steps still have to be corrected by.
    ComplexVector deflatedDirection;
    ComplexVector deflatedSum;
    double step = 0.0;
    double previous = 0.0;
    double halved = slope;
    int lastHalved = steps;
    for (; steps < MostLeastSquaresSteps && steps - lastHalved <= MostSlowSteps && this->GoOn();
         ++steps)
    {
      const double product = preconditioner.Apply(gradient, slope);
      const double keep = previous == 0.0 ? 0.0 : product / previous;
      ForRows(freeSystem.Free,
        [=, vertices = freeSystem.Free.data(), z = preconditioner.GetResult().data(),
          perUnit = static_cast<float>(slope / unit), kept = static_cast<float>(keep),
          along = step * unit, to = direction.data(), solution = better.data()](
          Index begin, Index end)
        {
          for (Index k = begin; k < end; ++k)
          {
            const Index v = vertices[k];
            solution[v] += along * Complex(to[v]);
            to[v] = perUnit * CompactComplex(z[2 * k], z[2 * k + 1]) + kept * to[v];
          }
        });
      if (previous != 0.0)
      {
        deflatedSum += step * deflatedDirection;
      }
      previous = product;
      // q = K_f direction
      matrix.Multiply(direction, q);
      deflatedDirection = unit * preconditioner.Deflate(q);
      if (keep == 0.0)
      {
        deflatedSum.setZero(deflatedDirection.size());
      }
      const double squares = RealDot(q, q);
      step = product / (unit * unit * squares);
      if (!(step > 0.0) || !std::isfinite(step))
      {
        step = 0.0;
        break;
      }
      Combine(-step * unit, q, 1.0, r);
      slope = findGradient(r, gradient);
      if (slope <= ResidualMargin * this->Tolerance * size)
      {
        ++steps;
        break;
      }
      if (slope <= 0.5 * halved)
      {
        halved = slope;
        lastHalved = steps;
      }
    }
    if (step > 0.0)
    {
      ForRows(better,
        [along = step * unit, from = direction.data(), solution = better.data()](
          Index begin, Index end)
        {
          for (Index v = begin; v < end; ++v)
          {
            solution[v] += along * Complex(from[v]);
          }
        });
      deflatedSum += step * deflatedDirection;
    }
    if (previous != 0.0)
    {
      preconditioner.Correct(deflatedSum, better);
    }
    matrix.Multiply(better, q);
    r = b - q;
    const double relative = findGradient(r, gradient) / size;
    const bool stalls = !(relative < 0.5 * solution.Residual);
    if (relative < solution.Residual)
    {
      solution.Residual = relative;
      x = std::move(better);
    }
    if (stalls || solution.Residual <= this->Tolerance)
    {
      break;
    }
  }
  solution.Vector += x;
  return solution;
}
}
