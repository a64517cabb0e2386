// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/LeastSquares.h"

#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradients.h"
#include "Solvers/Systems/LeastSquaresPreconditioner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Least squares take as many steps as they need, which on triangles of very different shapes are more
/// the more vertices there are, but end where so many have not halved the gradient.
constexpr int MostLeastSquaresSteps = 1200;
constexpr int MostSlowSteps = 60;
}

SystemSolution MinimizeResidualByMultigrid(const ShiftedSystem& system, const FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given)
{
  SystemSolution solution;
  solution.Vector = freeSystem.Free.Scattered(given);
  if (freeSystem.Free.IsEmpty())
  {
    return solution;
  }
  const CombinedMatrix matrix(system.Matrices, system.EnergyFactor, system.MassFactor);
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
  const std::vector<Index>& freeVertices = freeSystem.Free.GetVertices();
  LeastSquaresPreconditioner preconditioner(
    LinearCombination(system.Matrices, system.EnergyFactor, system.MassFactor), freeVertices,
    freeSystem.Hierarchy, std::max(0.0, system.Shift()));
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
    for (; steps < MostLeastSquaresSteps && steps - lastHalved <= MostSlowSteps && system.GoOn();
         ++steps)
    {
      const double product = preconditioner.Apply(gradient, slope);
      const double keep = previous == 0.0 ? 0.0 : product / previous;
      ForRows(freeVertices,
        [=, vertices = freeVertices.data(), z = preconditioner.GetResult().data(),
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
      if (slope <= ResidualMargin * system.Tolerance * size)
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
    if (stalls || solution.Residual <= system.Tolerance)
    {
      break;
    }
  }
  solution.Vector += x;
  return solution;
}
}
