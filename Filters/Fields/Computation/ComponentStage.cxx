// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/ComponentStage.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"
#include "Support/Division.h"
#include "Systems/ConjugateGradients.h"
#include "Systems/DirectSystem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
ComponentStage::ComponentStage(
  Operators matrices, SmallestPairs smoothest, double scale, double unit)
  : Matrices(std::move(matrices))
  , Smoothest(std::move(smoothest))
  , Scale(scale)
  , Unit(unit)
{
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

const SoftTerms* ComponentStage::SoftTermsOf(const ComponentGuide& guide)
{
  if (guide.Soft.IsEmpty() ? this->Soft != nullptr : !this->Soft || !this->Soft->Fit(guide.Soft))
  {
    this->Free.reset();
    this->Soft.reset();
    if (!guide.Soft.IsEmpty())
    {
      this->Soft = std::make_unique<SoftTerms>(this->Matrices, guide.Soft, this->Sigma());
    }
  }
  return this->Soft.get();
}

FreeSystem& ComponentStage::FreeSystemOf(const ComponentGuide& guide)
{
  const SoftTerms* const soft = this->SoftTermsOf(guide);
  if (!this->Free || this->Free->Given != guide.Given.Vertices)
  {
    this->Free = std::make_unique<FreeSystem>(
      soft ? soft->GetMatrices() : this->Matrices, guide.Given.Vertices, this->Scale);
  }
  return *this->Free;
}

double ComponentStage::Gap(const Options& options, double share) const
{
  return SystemGap(options, share, { this->Smoothest.First.Value, this->Smoothest.First.Residual },
    this->Scale, this->Unit);
}

double ComponentStage::SmallestGap() const
{
  return SmallestSystemGap(this->Smoothest.First.Value, this->Scale);
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

SystemSolution ComponentStage::SolveByMultigrid(const SystemFactors& factors,
  const ComponentGuide& guide, const ComplexVector& rightHandSide, const Options& options,
  const Progress& progress)
{
  const SoftTerms* const soft = this->SoftTermsOf(guide);
  const Operators& matrices = soft ? soft->GetMatrices() : this->Matrices;
  const WorkLimit limit(matrices.Energy, ShiftedSystem::DirectSolves, ShiftedSystem::DirectWork);
  const ShiftedSystem system{ matrices, factors.Energy, factors.Mass, SystemTolerance(options),
    progress, this->OthersFollow, options.Solver == Solver::Automatic ? &limit : nullptr };
  if (guide.Given.Vertices.empty() && !soft)
  {
    return ConjugateGradients(
      system, *this->Smoothest.Hierarchy, this->Smoothest.Lowest, rightHandSide, this->Solved);
  }
  return MinimizeEnergyByMultigrid(system, this->FreeSystemOf(guide), rightHandSide, guide.Given);
}

SystemSolution ComponentStage::SolveByFactor(const SystemFactors& factors,
  const ComponentGuide& guide, const ComplexVector& rightHandSide, const Options& options,
  const Progress& progress)
{
  const SoftTerms* const soft = this->SoftTermsOf(guide);
  const Operators& matrices = soft ? soft->GetMatrices() : this->Matrices;
  const SparseMatrix matrix = factors.Energy * matrices.Energy + factors.Mass * matrices.Mass;
  if (guide.Given.Vertices.empty())
  {
    return SolveDirectly(matrix, rightHandSide, progress);
  }
  return options.ConstraintSolver == ConstraintSolver::Energy || soft
    ? MinimizeEnergyDirectly(matrix, rightHandSide, guide.Given, progress)
    : MinimizeResidualDirectly(matrix, rightHandSide, guide.Given, progress);
}

SystemSolution ComponentStage::SolveSystem(const SystemFactors& factors,
  const ComponentGuide& guide, const ComplexVector& rightHandSide, const Options& options,
  const Progress& progress, ComponentReport& report)
{
  const bool leastSquares = options.ConstraintSolver == ConstraintSolver::LeastSquares &&
    !guide.Given.Vertices.empty() && guide.Soft.IsEmpty();
  // Multigrid has shown that it works on this component where the smoothest field was found by it.
  if (this->Smoothest.Hierarchy && !leastSquares)
  {
    SystemSolution solution =
      this->SolveByMultigrid(factors, guide, rightHandSide, options, progress);
    if (solution.Residual <= SystemTolerance(options) || options.Solver == Solver::Multigrid)
    {
      return solution;
    }
    progress.RequireToGoOn();
  }
  report.SolverUsed = Solver::Direct;
  return this->SolveByFactor(factors, guide, rightHandSide, options, progress);
}

SystemSolution ComponentStage::SolveAt(double gap, const ComponentGuide& guide,
  const GuidanceTerms& terms, const Options& options, const Progress& progress,
  ComponentReport& report)
{
  const double smallest = this->Smoothest.First.Value;
  for (;;)
  {
    SystemFactors factors;
    report.Lambda = 0.0;
    if (terms.Any())
    {
      factors = FactorsAt(smallest, gap);
      report.Lambda = std::isinf(gap) ? std::numeric_limits<double>::lowest()
                                      : PerSquare(smallest - gap, this->Unit);
    }
    report.SolverUsed = this->Smoothest.SolverUsed;
    ComplexVector rightHandSide = terms.RightHandSide(this->Matrices, factors.Guidance);
    if (const SoftTerms* const soft = this->SoftTermsOf(guide))
    {
      rightHandSide += factors.Energy * soft->GetPull();
    }
    try
    {
      return this->SolveSystem(factors, guide, rightHandSide, options, progress, report);
    }
    catch (const NotPositiveDefinite&)
    {
      if (!terms.Any() || gap >= smallest)
      {
        throw;
      }
      gap = GrownGap(gap, smallest, this->Scale);
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
  const bool constrained = !guide.Given.Vertices.empty() || !guide.Soft.IsEmpty();
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
