// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/ComponentStage.h"

#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradients.h"
#include "Solvers/Systems/DirectSystem.h"
#include "Support/Division.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A gap lambda_1 - lambda_t below this part of sigma leaves the smoothest field.
constexpr double SmallestRelativeGap = 1e-8;
/// Where A - lambda_t M turns out to be indefinite the gap grows by this factor.
constexpr double GapGrowth = 8.0;

/// A bound of the error of the computed lambda_1, over sigma: the square of its residual over the
/// distance to the next eigenvalue, which is assumed to be a hundredth of sigma, or the residual where
/// that is less.
double EigenvalueError(const Eigenpair& pair)
{
  constexpr double nearness = 100.0;
  return pair.Residual * std::min(1.0, nearness * pair.Residual);
}
}

ComponentStage::ComponentStage(
  Operators matrices, SmallestPairs smoothest, double scale, double unit)
  : Matrices(std::move(matrices))
  , Smoothest(std::move(smoothest))
  , Scale(scale)
  , Unit(unit)
{
}

ComponentStage::Factors ComponentStage::FactorsAt(double smallest, double gap)
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

const GuidanceTerms& ComponentStage::TermsOf(const ComponentGuide& guide)
{
  if (!this->Terms || !this->Terms->Fit(guide))
  {
    this->Terms.emplace(this->Matrices, guide);
  }
  return *this->Terms;
}

double ComponentStage::PerArea(double value) const
{
  return PerSquare(value, this->Unit);
}

double ComponentStage::Sigma() const
{
  return std::max(this->Smoothest.First.Value, this->Scale);
}

const Hierarchy& ComponentStage::GetHierarchy()
{
  if (this->Smoothest.Hierarchy)
  {
    return *this->Smoothest.Hierarchy;
  }
  if (!this->OwnHierarchy)
  {
    this->OwnHierarchy = std::make_unique<Hierarchy>(this->Matrices, this->Scale);
  }
  return *this->OwnHierarchy;
}

FreeSystem& ComponentStage::FreeSystemOf(const GivenValues& given)
{
  if (!this->Free || this->Free->Given != given.Vertices)
  {
    this->Free = std::make_unique<FreeSystem>(this->Matrices, given.Vertices, this->Scale);
  }
  return *this->Free;
}

double ComponentStage::Gap(const Options& options, double share) const
{
  const double sigma = this->Sigma();
  const double least = sigma * EigenvalueError(this->Smoothest.First);
  if (options.UseShift)
  {
    return std::clamp(options.Shift * this->Unit * this->Unit, least,
      std::max(least, std::numeric_limits<double>::max()));
  }
  const double tau = options.AlignmentStrength;
  return tau < 1.0 ? std::max(least, share * sigma * tau / (1.0 - tau))
                   : std::numeric_limits<double>::infinity();
}

double ComponentStage::SmallestGap() const
{
  return SmallestRelativeGap * std::max(this->Smoothest.First.Value, this->Scale);
}

ComplexVector ComponentStage::SmoothestTowards(const GuidanceTerms& terms) const
{
  ComplexVector u = this->Smoothest.First.Vector;
  if (terms.Any())
  {
    // This is the limit of the aligned fields where the strength tends to 0.
    const Complex overlap = u.dot(terms.GetMassTimes());
    u *= std::abs(overlap) > 0.0 ? overlap / std::abs(overlap) : Complex(1.0);
  }
  return u;
}

SystemSolution ComponentStage::SolveByMultigrid(const Factors& factors, const GivenValues& given,
  const ComplexVector& rightHandSide, const Options& options, const Progress& progress)
{
  const WorkLimit limit(
    this->Matrices.Energy, ShiftedSystem::DirectSolves, ShiftedSystem::DirectWork);
  const ShiftedSystem system{ this->Matrices, factors.Energy, factors.Mass,
    SystemTolerance(options), progress, this->OthersFollow,
    options.Solver == Solver::Automatic ? &limit : nullptr };
  if (given.Vertices.empty())
  {
    return ConjugateGradients(
      system, *this->Smoothest.Hierarchy, this->Smoothest.Lowest, rightHandSide, this->Solved);
  }
  return MinimizeEnergyByMultigrid(system, this->FreeSystemOf(given), rightHandSide, given);
}

SystemSolution ComponentStage::SolveByFactor(const Factors& factors, const GivenValues& given,
  const ComplexVector& rightHandSide, const Options& options, const Progress& progress) const
{
  const SparseMatrix matrix =
    factors.Energy * this->Matrices.Energy + factors.Mass * this->Matrices.Mass;
  if (given.Vertices.empty())
  {
    return SolveDirectly(matrix, rightHandSide, progress);
  }
  return options.ConstraintSolver == ConstraintSolver::Energy
    ? MinimizeEnergyDirectly(matrix, rightHandSide, given, progress)
    : MinimizeResidualDirectly(matrix, rightHandSide, given, progress);
}

SystemSolution ComponentStage::SolveSystem(const Factors& factors, const ComponentGuide& guide,
  const ComplexVector& rightHandSide, const Options& options, const Progress& progress,
  ComponentReport& report)
{
  const bool leastSquares =
    options.ConstraintSolver == ConstraintSolver::LeastSquares && !guide.Given.Vertices.empty();
  // Multigrid has shown that it works on this component where the smoothest field was found by it.
  if (this->Smoothest.Hierarchy && !leastSquares)
  {
    SystemSolution solution =
      this->SolveByMultigrid(factors, guide.Given, rightHandSide, options, progress);
    if (solution.Residual <= SystemTolerance(options) || options.Solver == Solver::Multigrid)
    {
      return solution;
    }
    progress.RequireToGoOn();
  }
  report.SolverUsed = Solver::Direct;
  return this->SolveByFactor(factors, guide.Given, rightHandSide, options, progress);
}

SystemSolution ComponentStage::SolveAt(double gap, const ComponentGuide& guide,
  const GuidanceTerms& terms, const Options& options, const Progress& progress,
  ComponentReport& report)
{
  const double smallest = this->Smoothest.First.Value;
  for (;;)
  {
    Factors factors{ 1.0, 0.0, 0.0 };
    report.Lambda = 0.0;
    if (terms.Any())
    {
      factors = FactorsAt(smallest, gap);
      report.Lambda = std::isinf(gap) ? std::numeric_limits<double>::lowest()
                                      : PerSquare(smallest - gap, this->Unit);
    }
    report.SolverUsed = this->Smoothest.SolverUsed;
    try
    {
      return this->SolveSystem(factors, guide,
        terms.RightHandSide(this->Matrices, factors.Guidance), options, progress, report);
    }
    catch (const NotPositiveDefinite&)
    {
      // The quotient of a section that has not converged may exceed lambda_1 by more than its residual
      // lets expect. lambda_t = 0 is safe.
      if (!terms.Any() || gap >= smallest)
      {
        throw;
      }
      gap = std::min(smallest, std::max(GapGrowth * gap, this->SmallestGap()));
    }
  }
}

ComplexVector ComponentStage::Finish(
  SystemSolution solution, double area, const Options& options, ComponentReport& report) const
{
  SectionProducts u;
  if (solution.Energy.size() > 0)
  {
    u.Vector = std::move(solution.Vector);
    u.Energy = std::move(solution.Energy);
    u.Mass = std::move(solution.Mass);
  }
  else
  {
    u.Set(this->Matrices, std::move(solution.Vector));
  }
  const double size = RealDot(u.Vector, u.Mass);
  report.SmoothnessEnergy =
    size > 0.0 ? PerSquare(std::max(0.0, RealDot(u.Vector, u.Energy) / size), this->Unit) : 0.0;
  report.SystemResidual = solution.Residual;
  const Eigenpair& smoothest = this->Smoothest.First;
  report.Eigenvalue = PerSquare(smoothest.Value, this->Unit);
  report.Residual = smoothest.Residual;
  report.RequiredResidual = smoothest.RequiredResidual;
  report.Iterations = smoothest.Iterations;
  report.Converged = HasConverged(smoothest) && report.SystemResidual <= SystemTolerance(options);
  if (size > 0.0)
  {
    const double factor = std::sqrt(area / size);
    ForRows(
      u.Vector, [&](Index begin, Index end) { u.Vector.segment(begin, end - begin) *= factor; });
  }
  return std::move(u.Vector);
}

ComplexVector ComponentStage::Solve(const ComponentGuide& guide, const Options& options,
  const Progress& progress, ComponentReport& report)
{
  const GuidanceTerms& terms = this->TermsOf(guide);
  const bool constrained = !guide.Given.Vertices.empty();
  const double gap = this->Gap(options, guide.Share);
  SystemSolution solution;
  if (constrained || (terms.Any() && gap > this->SmallestGap()))
  {
    solution = this->SolveAt(gap, guide, terms, options, progress, report);
  }
  else
  {
    report.SolverUsed = this->Smoothest.SolverUsed;
    report.Lambda = PerSquare(this->Smoothest.First.Value, this->Unit);
    solution.Vector = this->SmoothestTowards(terms);
  }
  if (solution.Vector.isZero(0.0))
  {
    // Constraints that are zero give the zero field: the smoothest one is better than none.
    solution.Energy.resize(0);
    solution.Mass.resize(0);
    solution.Vector = this->SmoothestTowards(terms);
  }
  return this->Finish(std::move(solution), terms.GetArea(), options, report);
}
}
