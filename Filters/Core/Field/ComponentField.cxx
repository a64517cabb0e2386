// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/ComponentField.h"

#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradients.h"
#include "Solvers/Systems/DirectSystem.h"
#include "Solvers/Systems/LeastSquares.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields
{
namespace
{
/// A gap lambda_1 - lambda_t below this part of sigma leaves the smoothest field: what the guidance
/// still changes there is below rounding.
constexpr double SmallestGap = 1e-8;
/// Where A - lambda_t M turns out to be indefinite the gap grows by this factor.
constexpr double GapGrowth = 8.0;

/// K = A - lambda_t M = Energy A + Mass M and the factor lambda_1 - lambda_t of M q, all over any
/// positive number.
struct Factors
{
  double Energy;
  double Mass;
  double Guidance;
};

Factors MakeFactors(double smallest, double gap)
{
  if (std::isinf(gap))
  {
    return { 0.0, 1.0, 1.0 };
  }
  if (gap > 1.0)
  {
    return { 1.0 / gap, 1.0 - smallest / gap, 1.0 };
  }
  return { 1.0, gap - smallest, gap };
}

/// How far off the computed lambda_1 may be, over sigma: by the square of its residual over how far
/// the next one is, but by no more than the residual.
double EigenvalueError(const Eigenpair& pair)
{
  constexpr double nearness = 100.0;
  return pair.Residual * std::min(1.0, nearness * pair.Residual);
}

/// lambda_1 - lambda_t, 0 to infinity. No less than lambda_1 is known to, or A - lambda_t M could be
/// indefinite.
double Gap(const ComponentProblem& problem, const Options& options)
{
  const double sigma = std::max(problem.Smoothest.First.Value, problem.Scale);
  const double least = sigma * EigenvalueError(problem.Smoothest.First);
  if (options.UseShift)
  {
    return std::clamp(options.Shift * problem.Unit * problem.Unit, least,
      std::max(least, std::numeric_limits<double>::max()));
  }
  const double tau = options.AlignmentStrength;
  return tau < 1.0 ? std::max(least, sigma * tau / (1.0 - tau))
                   : std::numeric_limits<double>::infinity();
}

/// A third of the area of the triangles at each vertex. Each triangle adds a sixth of its area to
/// the diagonal at its three corners.
Eigen::VectorXd VertexAreas(const SparseMatrix& mass)
{
  Eigen::VectorXd areas(mass.cols());
  ParallelFor(static_cast<Index>(mass.cols()), VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        areas[v] = 2.0 * mass.coeff(v, v).real();
      }
    });
  return areas;
}

/// Calls set(v) at constrained vertices and their neighbours: those of the matrices, the rows that
/// constrained values enter.
template <typename Set>
void ForEachNearConstraints(const ComponentProblem& problem, const Set& set)
{
  for (const Index v : problem.Given.Vertices)
  {
    for (SparseMatrix::InnerIterator it(problem.Matrices.Mass, v); it; ++it)
    {
      set(it.row());
    }
  }
}

/// The guidance scaled to modulus 1 in the mean square over where the areas are not 0; empty where
/// nothing is left of it there.
ComplexVector Normalized(ComplexVector guidance, const Eigen::VectorXd& areas)
{
  struct Range
  {
    double Value = 0.0;
    Range& operator+=(const Range& other)
    {
      this->Value = std::max(this->Value, other.Value);
      return *this;
    }
  };
  const auto rows = static_cast<Index>(guidance.size());
  // First by the largest: squares of tiny guidance must not underflow.
  const double largest = ParallelSum<Range>(rows, VectorPiece, {},
    [&](Index begin, Index end)
    {
      Range part;
      for (Index v = begin; v < end; ++v)
      {
        if (areas[v] > 0.0)
        {
          part += { std::max(std::abs(guidance[v].real()), std::abs(guidance[v].imag())) };
        }
      }
      return part;
    }).Value;
  if (!(largest > 0.0))
  {
    return {};
  }
  // Part by part: the quotient of complex numbers would square the divisor.
  ForRows(guidance,
    [&](Index begin, Index end)
    {
      guidance.segment(begin, end - begin).real() /= largest;
      guidance.segment(begin, end - begin).imag() /= largest;
    });
  const double squares = ParallelSum<double>(rows, VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      return areas.segment(begin, end - begin)
        .dot(guidance.segment(begin, end - begin).cwiseAbs2());
    });
  const double factor = std::sqrt(areas.sum() / squares);
  ForRows(guidance,
    [&](Index begin, Index end) { guidance.segment(begin, end - begin) *= factor; });
  return guidance;
}

/// Made anew where guidance or constraints have changed.
const GuidanceTerms& GetTerms(const ComponentProblem& problem)
{
  const ComplexVector& guidance = problem.Guidance;
  std::optional<GuidanceTerms>& terms = problem.Terms;
  if (terms && terms->GivenVertices == problem.Given.Vertices &&
    terms->Guidance.size() == guidance.size() && Equal(terms->Guidance, guidance))
  {
    return *terms;
  }
  terms.emplace();
  terms->Guidance = guidance;
  terms->GivenVertices = problem.Given.Vertices;
  Eigen::VectorXd areas = VertexAreas(problem.Matrices.Mass);
  terms->Area = areas.sum();
  ForEachNearConstraints(problem, [&](Index v) { areas[v] = 0.0; });
  const ComplexVector scaled = Normalized(guidance, areas);
  if (scaled.size() > 0)
  {
    terms->MassTimes = Product(problem.Matrices.Mass, scaled);
  }
  return *terms;
}

/// The factor times M q, zero where constraints have a say; zero without guidance.
ComplexVector RightHandSide(
  const ComponentProblem& problem, const GuidanceTerms& terms, double factor)
{
  if (terms.MassTimes.size() == 0)
  {
    return ComplexVector::Zero(problem.Matrices.Energy.rows());
  }
  ComplexVector b = Uninitialized(terms.MassTimes.size());
  ForRows(b,
    [&](Index begin, Index end)
    { b.segment(begin, end - begin) = factor * terms.MassTimes.segment(begin, end - begin); });
  ForEachNearConstraints(problem, [&](Index v) { b[v] = 0.0; });
  return b;
}

SystemSolution SolveByMultigrid(const ComponentProblem& problem, const Options& options,
  const Factors& factors, const ComplexVector& b)
{
  const ShiftedSystem system{ problem.Matrices, factors.Energy, factors.Mass,
    SystemTolerance(options), problem.GoOn, options.OthersFollow };
  if (problem.Given.Vertices.empty())
  {
    return ConjugateGradients(
      system, *problem.Smoothest.Hierarchy, problem.Smoothest.Lowest, b, problem.Solved);
  }
  if (!problem.Free || problem.Free->Given != problem.Given.Vertices)
  {
    problem.Free =
      std::make_unique<FreeSystem>(problem.Matrices, problem.Given.Vertices, problem.Scale);
  }
  return options.ConstraintSolver == ConstraintSolver::Energy
    ? MinimizeEnergyByMultigrid(system, *problem.Free, b, problem.Given)
    : MinimizeResidualByMultigrid(system, *problem.Free, b, problem.Given);
}

SystemSolution SolveByFactor(const ComponentProblem& problem, const Options& options,
  const Factors& factors, const ComplexVector& b)
{
  const SparseMatrix matrix =
    factors.Energy * problem.Matrices.Energy + factors.Mass * problem.Matrices.Mass;
  try
  {
    return problem.Given.Vertices.empty() ? SolveDirectly(matrix, b, problem.GoOn)
      : options.ConstraintSolver == ConstraintSolver::Energy
      ? MinimizeEnergyDirectly(matrix, b, problem.Given, problem.GoOn)
      : MinimizeResidualDirectly(matrix, b, problem.Given, problem.GoOn);
  }
  catch (const Stopped&)
  {
    SystemSolution none;
    none.Vector = ComplexVector::Zero(b.size());
    none.Residual = 1.0;
    return none;
  }
}

/// By multigrid where the smoothest field was found by it.
SystemSolution SolveSystem(const ComponentProblem& problem, const Options& options,
  const Factors& factors, const ComplexVector& b, ComponentReport& report)
{
  if (problem.Smoothest.Hierarchy)
  {
    SystemSolution solution = SolveByMultigrid(problem, options, factors, b);
    if (solution.Residual <= SystemTolerance(options) || options.Solver == Solver::Multigrid ||
      !problem.GoOn())
    {
      return solution;
    }
    report.SolverUsed = Solver::Direct;
  }
  return SolveByFactor(problem, options, factors, b);
}
}

ComplexVector SolveComponent(
  const ComponentProblem& problem, const Options& options, ComponentReport& report)
{
  const Operators& matrices = problem.Matrices;
  const double smallest = problem.Smoothest.First.Value;
  const double unit = problem.Unit;
  const GuidanceTerms& terms = GetTerms(problem);
  const bool guided = terms.MassTimes.size() > 0;
  const bool constrained = !problem.Given.Vertices.empty();
  double gap = Gap(problem, options);
  const bool smoothest = gap <= SmallestGap * std::max(smallest, problem.Scale);

  SystemSolution solution;
  const auto takeSmoothest = [&]
  {
    solution.Energy.resize(0);
    solution.Mass.resize(0);
    solution.Vector = problem.Smoothest.First.Vector;
    if (guided)
    {
      // The limit of the aligned fields: of all phases the one closest to the guidance.
      const Complex overlap = solution.Vector.dot(terms.MassTimes);
      solution.Vector *= std::abs(overlap) > 0.0 ? overlap / std::abs(overlap) : Complex(1.0);
    }
  };
  report.SolverUsed = problem.Smoothest.SolverUsed;
  report.Lambda = PerSquare(smallest, unit);
  if (!constrained && (!guided || smoothest))
  {
    takeSmoothest();
  }
  else
  {
    for (bool solved = false; !solved;)
    {
      report.Lambda = !guided ? 0.0
        : std::isinf(gap)     ? std::numeric_limits<double>::lowest()
                              : PerSquare(smallest - gap, unit);
      const Factors factors = guided ? MakeFactors(smallest, gap) : Factors{ 1.0, 0.0, 0.0 };
      try
      {
        solution = SolveSystem(
          problem, options, factors, RightHandSide(problem, terms, factors.Guidance), report);
        solved = true;
      }
      catch (const NotPositiveDefinite&)
      {
        // Of a section that has not converged, the quotient may exceed lambda_1 by more than that
        // section lets expect. lambda_t = 0 is safe.
        if (!guided || gap >= smallest)
        {
          throw;
        }
        gap = std::min(smallest,
          std::max(GapGrowth * gap, SmallestGap * std::max(smallest, problem.Scale)));
        report.SolverUsed = problem.Smoothest.SolverUsed;
      }
    }
    if (solution.Vector.isZero(0.0))
    {
      // Nothing came of it, or of constraints that are zero: better a field than none.
      takeSmoothest();
    }
  }
  SectionProducts u;
  if (solution.Energy.size() > 0)
  {
    u.Vector = std::move(solution.Vector);
    u.Energy = std::move(solution.Energy);
    u.Mass = std::move(solution.Mass);
  }
  else
  {
    u.Set(matrices, std::move(solution.Vector));
  }
  const double size = RealDot(u.Vector, u.Mass);
  report.SmoothnessEnergy =
    size > 0.0 ? PerSquare(std::max(0.0, RealDot(u.Vector, u.Energy) / size), unit) : 0.0;
  report.SystemResidual = solution.Residual;
  if (size > 0.0)
  {
    const double factor = std::sqrt(terms.Area / size);
    ForRows(u.Vector,
      [&](Index begin, Index end) { u.Vector.segment(begin, end - begin) *= factor; });
  }
  return std::move(u.Vector);
}
}
