// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/UnitLengthField.h"

#include "Sections/DoubleCover.h"
#include "Sections/Singularities.h"
#include "UnitLength/LevelDiffusion.h"
#include "UnitLength/PairCancellation.h"
#include "UnitLength/PhaseDescent.h"
#include "UnitLength/SingularityMoves.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
/// V-cycles for each step of diffusion on the finest level after the coarse ones.
constexpr int FineCycles = 2;
/// Where a guidance draws, it has brought the singularities near their places in the start; and
/// where levels hardly get smaller, coarse ones are of little use. Then there are these times, over
/// the inverse of the rate, with this many cycles each. Singularities of linear systems with given
/// values may be far from where they belong.
const std::vector<double> FreeTimes = { 0.3, 0.1, 0.03, 0.01 };
constexpr int FreeCycles = 1;
const std::vector<double> GivenTimes = { 3.0, 3.0, 3.0, 1.0, 1.0, 0.3, 0.3, 0.1, 0.03, 0.01 };
constexpr int GivenCycles = 3;
/// Sweeps over the singularities that might move. Those of linear systems with given values may be
/// far from where they belong.
constexpr int SweepsOfFree = 2;
constexpr int SweepsOfGiven = 12;
/// Later rounds look at changed places only, and find little that the first has left.
constexpr int Rounds = 3;
/// The descent ends where a step lowers the energy by less than this part.
constexpr double Decrease = 3e-4;
constexpr int StepsBetween = 5;
constexpr int LastSteps = 12;
/// The number of steps, down to this part, that show whether pairs cancelled on approval were worth
/// it, and that follow on moves.
constexpr int StepsOfApproval = 10;
constexpr int StepsOfMoves = 3;
constexpr double RoughDecrease = 1e-3;
/// Energies below this, which has no unit, are those of parallel fields, up to rounding: there is
/// nothing to gain.
constexpr double Parallel = 1e-9;

/// The number of starts on small surfaces is this over that of the vertices, up to the next number:
/// all of them together take about as long as one start on a surface of so many vertices.
constexpr Index VerticesOfStarts = 2000;
constexpr int MostStartsBySize = 16;
/// Another start is taken where it lowers the price by more than this part: among equals the first
/// one, which does not depend on the numbers of the vertices, is the most stable.
constexpr double Lower = 1e-3;

/// Leads from a start to a field of unit length.
class Improvement
{
public:
  Improvement(const UnitLengthProblem& problem, const Hierarchy& hierarchy,
    const FreeVertices* free, const UnitLengthSettings& settings, const Progress& progress,
    ComplexVector& u)
    : Problem(problem)
    , Settings(settings)
    , Progress(progress)
    , Matrices(hierarchy)
    , Free(free)
    , Descent(problem, hierarchy, free)
    , U(u)
  {
    MakeUnit(this->U);
    this->Report.EnergyBefore = problem.Energy(this->U);
    this->Report.EnergyAfter = this->Report.EnergyBefore;
  }

  UnitLengthReport Run()
  {
    if (std::abs(this->Report.EnergyBefore) < Parallel)
    {
      return this->Report;
    }
    const ComplexVector start = this->U;
    this->Diffuse();
    this->Polish(this->U, Decrease, StepsBetween);
    PairCancellation pairs(this->Problem, this->Settings.SingularityCost);
    for (int round = 0; round < Rounds; ++round)
    {
      this->Progress.Report(0.2 + 0.3 * round);
      const int cancelled = pairs.Round(this->U, this->Progress);
      this->Report.CancelledPairs += cancelled;
      if (cancelled > 0)
      {
        this->Polish(this->U, Decrease, StepsBetween);
      }
      if (!this->CancelOnApproval(pairs) && cancelled == 0)
      {
        break;
      }
    }
    this->Progress.Report(0.8);
    this->MoveSingularities(this->Problem.IsGiven.empty() ? SweepsOfFree : SweepsOfGiven);
    this->Polish(this->U, Decrease, LastSteps);
    this->Report.EnergyAfter = this->Problem.Energy(this->U);
    if (this->Price(this->U, this->Report.EnergyAfter) >
      this->Price(start, this->Report.EnergyBefore))
    {
      this->U = start;
      this->Report.EnergyAfter = this->Report.EnergyBefore;
      this->Report.CancelledPairs = 0;
    }
    return this->Report;
  }

  /// The energy and the cost of the singularities. Those at given values cost nothing: the corners
  /// of features and of the boundary ask for them.
  double Price(const ComplexVector& u, double energy) const
  {
    if (this->Settings.SingularityCost == 0.0)
    {
      return energy;
    }
    const std::vector<int> indices = SingularityIndices(
      this->Problem.Geometry, this->Problem.Component, this->Problem.Degree, u.data());
    double count = 0.0;
    for (Index t = 0; t < static_cast<Index>(indices.size()); ++t)
    {
      const bool isFree = !this->Problem.IsAtGiven(this->Problem.Component.FirstTriangle + t);
      count += isFree ? std::abs(indices[t]) : 0;
    }
    return energy + this->Settings.SingularityCost * count;
  }

private:
  void Diffuse()
  {
    LevelDiffusion diffusion(this->Problem, this->Matrices, this->Free, this->Settings.Rate);
    if (this->Problem.Pull.size() > 0 || !diffusion.IsPossible())
    {
      const bool isFree = this->Problem.IsGiven.empty();
      this->DiffuseFor(isFree ? FreeTimes : GivenTimes, isFree ? FreeCycles : GivenCycles);
      return;
    }
    // Coarse levels bring the singularities to their places, the finest one smooths what the
    // interpolation from them has left.
    this->Report.Steps += diffusion.Run(this->Progress, this->U);
    for (const double shift : diffusion.FineShifts())
    {
      this->DiffuseOnce(shift, FineCycles);
    }
  }

  /// Diffuses for these times over the inverse of the rate.
  void DiffuseFor(const std::vector<double>& times, int cycles)
  {
    for (const double time : times)
    {
      this->DiffuseOnce(this->Settings.Rate / time, cycles);
    }
  }

  void DiffuseOnce(double shift, int cycles)
  {
    this->Progress.RequireToGoOn();
    this->Descent.Diffuse(this->Settings.Pull + shift, cycles, this->U);
    ++this->Report.Steps;
  }

  void Polish(ComplexVector& u, double decrease, int mostSteps)
  {
    this->Report.Steps +=
      this->Descent.Polish(this->Settings.Pull, decrease, mostSteps, this->Progress, u);
  }

  void MoveSingularities(int sweeps)
  {
    SingularityMoves moves(this->Problem);
    for (int sweep = 0; sweep < sweeps && !moves.IsDone(); ++sweep)
    {
      this->Progress.RequireToGoOn();
      if (moves.Sweep(this->U) > 0)
      {
        this->Polish(this->U, RoughDecrease, StepsOfMoves);
      }
    }
  }

  /// Cancels the pairs that are predicted to pay off, and takes all of them back if they do not.
  bool CancelOnApproval(PairCancellation& pairs)
  {
    ComplexVector tried = this->U;
    const int cancelled = pairs.CancelOnApproval(tried);
    if (cancelled == 0)
    {
      return false;
    }
    this->Polish(tried, RoughDecrease, StepsOfApproval);
    if (!(this->Price(tried, this->Problem.Energy(tried)) <
          this->Price(this->U, this->Problem.Energy(this->U))))
    {
      return false;
    }
    this->U = std::move(tried);
    this->Report.CancelledPairs += cancelled;
    return true;
  }

  const UnitLengthProblem& Problem;
  const UnitLengthSettings& Settings;
  const DirectionFields::Progress& Progress;
  const Hierarchy& Matrices;
  const FreeVertices* Free;
  PhaseDescent Descent;
  ComplexVector& U;
  UnitLengthReport Report;
};

/// Random values of modulus 1 at the free vertices, the same ones everywhere.
void SetRandom(const UnitLengthProblem& problem, std::minstd_rand& random, ComplexVector& u)
{
  constexpr double range = std::minstd_rand::modulus;
  for (Index v = 0; v < problem.Rows(); ++v)
  {
    const double angle = 2.0 * Pi * static_cast<double>(random()) / range;
    u[v] = problem.IsFree(v) ? std::polar(1.0, angle) : u[v];
  }
  if (problem.Component.IsCover)
  {
    DoubleCover(problem.Surface, problem.Component, problem.Degree).Symmetrize(u);
    MakeUnit(u);
  }
}

int StartsBySize(const UnitLengthProblem& problem)
{
  const Index vertices = std::max(1, problem.Surface.Mesh.GetNumberOfVertices());
  return std::clamp(static_cast<int>(VerticesOfStarts / vertices), 1, MostStartsBySize);
}
}

UnitLengthReport MakeUnitLength(const UnitLengthProblem& problem, const Hierarchy& hierarchy,
  const FreeVertices* free, const UnitLengthSettings& settings, const Progress& progress,
  ComplexVector& u)
{
  const int starts = settings.Starts > 0 ? settings.Starts : StartsBySize(problem);
  const auto part = [&](int k)
  { return progress.Part(static_cast<double>(k) / starts, (k + 1.0) / starts); };
  const ComplexVector start = u;
  const Progress whole = part(0);
  Improvement first(problem, hierarchy, free, settings, whole, u);
  UnitLengthReport report = first.Run();
  double least = first.Price(u, report.EnergyAfter);
  std::minstd_rand random(1);
  for (int k = 1; k < starts && std::abs(report.EnergyAfter) >= Parallel; ++k)
  {
    ComplexVector other = start;
    SetRandom(problem, random, other);
    const Progress partial = part(k);
    Improvement improvement(problem, hierarchy, free, settings, partial, other);
    const UnitLengthReport made = improvement.Run();
    report.Steps += made.Steps;
    const double price = improvement.Price(other, made.EnergyAfter);
    if (price < least - Lower * std::abs(least))
    {
      least = price;
      u = std::move(other);
      report.EnergyAfter = made.EnergyAfter;
      report.CancelledPairs = made.CancelledPairs;
    }
  }
  return report;
}
}
