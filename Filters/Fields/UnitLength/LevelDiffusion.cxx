// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/LevelDiffusion.h"

#include "Matrices/VectorOperations.h"
#include "Multigrid/Cycle.h"
#include "Sections/DoubleCover.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace DirectionFields::Internal
{
namespace
{
/// The longest time is this part of the inverse of the rate; the next ones are shorter by a factor.
constexpr double LongestTime = 0.3;
constexpr double NextOnLevels = 3.0;
constexpr double NextOnFinest = 4.0;
/// The coarsest level has at least this many rows, too few to tell singularities apart otherwise,
/// and the next to the finest no more than this part of the finest: levels of noisy surfaces and
/// of long triangles hardly get smaller, and would take as long as the surface itself.
constexpr Index FewestRows = 60;
constexpr double MostRows = 0.25;
/// A time is over where a step changes the values by less than this in the mean square, or after
/// this many steps, of this many cycles each.
constexpr double NoChange = 1e-5;
constexpr int MostSteps = 12;
constexpr int Cycles = 2;

float* Floats(LargeArray<CompactComplex>& values)
{
  return reinterpret_cast<float*>(values.data());
}

/// Scales each value to modulus 1; where it vanishes, that of the other section is taken.
void MakeUnit(const LargeArray<CompactComplex>& other, LargeArray<CompactComplex>& x)
{
  constexpr float vanishing = 1e-18F;
  ParallelFor(static_cast<Index>(x.size()), VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const float size = Modulus(x[v]);
        x[v] = size > vanishing && std::isfinite(size) ? x[v] / size : other[v];
      }
    });
}

/// The inverse of the time in which values spread less than the vertices of a level are apart, and
/// singularities are held where they are: on an even triangulation, twice that of the squared
/// length of an edge.
double RateOf(const Hierarchy::Level& level)
{
  double energy = 0.0;
  double mass = 0.0;
  for (Index v = 0; v < level.Rows(); ++v)
  {
    energy += level.Matrices.Energy.Diagonal[v];
    mass += level.LumpedMass[v];
  }
  return 0.5 * energy / mass;
}

/// One step on a level. Returns the mean squared change of the values.
double Step(const Hierarchy::Level& level, std::size_t number, const Cycle& cycle, double shift,
  const LargeArray<CompactComplex>& held, LargeArray<CompactComplex>& y)
{
  const CompactMatrix& energy = level.Matrices.Energy;
  const Index rows = level.Rows();
  LargeArray<CompactComplex> x(y);
  LargeArray<CompactComplex> rest(rows);
  LargeArray<CompactComplex> way(rows);
  for (int k = 0; k < Cycles; ++k)
  {
    ParallelFor(rows, CompactMatrix::PieceRows,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          rest[v] = held[v] - energy.RowTimes<1>(v, Floats(x)).Value() -
            static_cast<float>(shift) * level.LumpedMass[v] * (x[v] - y[v]);
        }
      });
    cycle.Apply<1>(Floats(rest), Floats(way), number);
    ParallelFor(rows, VectorPiece,
      [&](Index begin, Index end) {
        std::transform(&x[begin], &x[begin] + (end - begin), &way[begin], &x[begin], std::plus<>());
      });
  }
  MakeUnit(y, x);
  const double changes = ParallelSum<double>(rows, VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        sum += std::norm(x[v] - y[v]);
      }
      return sum;
    });
  y.swap(x);
  return changes / rows;
}
}

LevelDiffusion::LevelDiffusion(const UnitLengthProblem& problem, const Hierarchy& hierarchy,
  const FreeVertices* free, double rate)
  : Problem(problem)
  , Matrices(hierarchy)
  , Free(free)
  , Shift(rate / LongestTime)
{
}

bool LevelDiffusion::IsPossible() const
{
  const std::vector<Hierarchy::Level>& levels = this->Matrices.GetLevels();
  return levels.size() > 1 && levels[1].Rows() >= FewestRows &&
    levels[1].Rows() <= MostRows * levels[0].Rows();
}

void LevelDiffusion::RestrictTo(std::size_t coarsest, const ComplexVector& u)
{
  const std::vector<Hierarchy::Level>& levels = this->Matrices.GetLevels();
  const Index rows = levels.front().Rows();
  this->Sections.assign(coarsest + 1, {});
  this->Held.assign(coarsest + 1, {});
  ComplexVector given = ComplexVector::Zero(u.size());
  for (Index v = 0; v < static_cast<Index>(u.size()); ++v)
  {
    given[v] = this->Problem.IsFree(v) ? Complex(0.0) : u[v];
  }
  const ComplexVector gradient = this->Problem.Gradient(given);
  this->Sections[0] = Values(rows);
  this->Held[0] = Values(rows);
  for (Index row = 0; row < rows; ++row)
  {
    this->Sections[0][row] = CompactComplex(u[this->Vertex(row)]);
    this->Held[0][row] = CompactComplex(-gradient[this->Vertex(row)]);
  }
  for (std::size_t l = 0; l < coarsest; ++l)
  {
    const Index coarse = levels[l + 1].Rows();
    for (std::vector<Values>* const values : { &this->Sections, &this->Held })
    {
      (*values)[l + 1] = Values(coarse);
      levels[l].FromCoarser.Restrict<1>(Floats((*values)[l]), Floats((*values)[l + 1]));
    }
    MakeUnit(Values(coarse, CompactComplex(1.0F)), this->Sections[l + 1]);
  }
}

int LevelDiffusion::RunOn(std::size_t l, const Progress& progress)
{
  const Hierarchy::Level& level = this->Matrices.GetLevels()[l];
  const double finest = RateOf(level);
  int steps = 0;
  for (;;)
  {
    const Cycle cycle(this->Matrices, this->Shift);
    double change = cycle.IsUsable() ? 1.0 : 0.0;
    for (int k = 0; k < MostSteps && change > NoChange; ++k)
    {
      progress.RequireToGoOn();
      change = Step(level, l, cycle, this->Shift, this->Held[l], this->Sections[l]);
      ++steps;
    }
    if (!(this->Shift < finest) || !std::isfinite(finest))
    {
      return steps;
    }
    this->Shift = std::min(NextOnLevels * this->Shift, finest);
  }
}

int LevelDiffusion::Run(const Progress& progress, ComplexVector& u)
{
  const std::vector<Hierarchy::Level>& levels = this->Matrices.GetLevels();
  std::size_t coarsest = 0;
  while (coarsest + 1 < levels.size() && levels[coarsest + 1].Rows() >= FewestRows)
  {
    ++coarsest;
  }
  this->RestrictTo(coarsest, u);
  int steps = 0;
  for (std::size_t l = coarsest; l > 0; --l)
  {
    steps += this->RunOn(l, progress);
    const Values before = this->Sections[l - 1];
    levels[l - 1].FromCoarser.Prolong<1>(Floats(this->Sections[l]), Floats(this->Sections[l - 1]));
    MakeUnit(before, this->Sections[l - 1]);
  }
  ComplexVector x = Copied(u);
  for (Index row = 0; row < levels.front().Rows(); ++row)
  {
    x[this->Vertex(row)] = Complex(this->Sections[0][row]);
  }
  if (this->Problem.Component.IsCover)
  {
    DoubleCover(this->Problem.Surface, this->Problem.Component, this->Problem.Degree).Symmetrize(x);
  }
  Internal::MakeUnit(x, &u);
  for (Index row = 0; row < levels.front().Rows(); ++row)
  {
    u[this->Vertex(row)] = x[this->Vertex(row)];
  }
  return steps;
}

std::vector<double> LevelDiffusion::FineShifts() const
{
  const Hierarchy::Level& finest = this->Matrices.GetLevels().front();
  const double last = RateOf(finest);
  std::vector<double> shifts;
  for (double shift = this->Shift;; shift = std::min(NextOnFinest * shift, last))
  {
    shifts.push_back(shift);
    if (!(shift < last) || !std::isfinite(last))
    {
      return shifts;
    }
  }
}
}
