// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Multigrid/Hierarchy.h"

#include "Solvers/Multigrid/Galerkin.h"
#include "Solvers/Multigrid/SmoothedAggregation.h"
#include "Support/Threads.h"

#include <utility>

namespace DirectionFields
{
namespace
{
/// Coarsening ends where a level would have more than this part of the rows of the finer one, and the
/// finer one is small enough to be factored.
constexpr double SlowestCoarsening = 0.7;
/// It ends anyway where a level would have more than this part.
constexpr double NoCoarsening = 0.95;
/// A level has at least this many rows where it is to hold eigenvectors.
constexpr Index FewestRows = 8;
/// With more rows than this, the storage of the pieces that coarse levels were made of is returned to the
/// system: it would count towards the peak of what comes next.
constexpr Index ManyRows = 1 << 20;

LargeArray<float> Lumped(const LevelMatrices& matrices)
{
  const CompactMatrix& energy = matrices.Energy;
  LargeArray<float> lumped(matrices.MassDiagonal);
  ParallelFor(energy.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
        {
          lumped[v] += Modulus(matrices.MassValue[k]);
        }
      }
    });
  return lumped;
}

LevelMatrices Finest(const Operators& operators)
{
  LevelMatrices finest;
  finest.Energy = CompactMatrix(operators.Energy);
  CompactMatrix mass(operators.Mass);
  finest.MassValue = std::move(mass.Value);
  finest.MassDiagonal = std::move(mass.Diagonal);
  return finest;
}
}

Hierarchy::Hierarchy(const Operators& operators, double scale, LeftOver leftOver)
  : Scale(scale)
{
  this->Levels.push_back({ Finest(operators), {}, {} });
  for (;;)
  {
    Level& level = this->Levels.back();
    level.LumpedMass = Lumped(level.Matrices);
    if (level.Rows() <= CoarsestRows)
    {
      break;
    }
    Prolongator prolongator =
      MakeProlongator(level.Matrices, static_cast<int>(this->Levels.size()) - 1, leftOver);
    if (prolongator.CoarseRows() > SlowestCoarsening * level.Rows() &&
      level.Rows() <= MostCoarsestRows)
    {
      break;
    }
    const Index fewest = leftOver == LeftOver::Keep ? FewestRows : 1;
    if (prolongator.CoarseRows() > NoCoarsening * level.Rows() ||
      prolongator.CoarseRows() < fewest)
    {
      break;
    }
    LevelMatrices coarse = Coarsen(level.Matrices, prolongator);
    level.FromCoarser = std::move(prolongator);
    if (this->Levels.size() == 1)
    {
      // The operators hold the same entries.
      Free(level.Matrices.MassValue);
    }
    this->Levels.push_back({ std::move(coarse), {}, {} });
  }
  if (this->Levels.front().Rows() > ManyRows)
  {
    ReturnReleased();
  }
  for (Level& level : this->Levels)
  {
    level.Matrices.Energy.PrepareSweeps();
  }
  // On coarser levels more sweeps would save no cycles.
  this->Levels.front().Matrices.Energy.FindLocalRows();
}

double Hierarchy::OperatorComplexity() const
{
  double entries = 0.0;
  for (const Level& level : this->Levels)
  {
    entries += static_cast<double>(level.Matrices.Energy.Entries()) + level.Rows();
  }
  const Level& finest = this->Levels.front();
  return entries / (static_cast<double>(finest.Matrices.Energy.Entries()) + finest.Rows());
}
}
