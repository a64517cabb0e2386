// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Hierarchy.h"

#include "Matrices/SparseColumns.h"
#include "Multigrid/Galerkin.h"
#include "Multigrid/SmoothedAggregation.h"
#include "Support/Free.h"
#include "Support/Threads.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Coarsening ends where a level would have more than this part of the rows of the finer one. Where
/// neighbouring values have little to do with each other after transport, as on very rough
/// surfaces, there are no aggregates; then sweeps solve for the remaining rows, and further levels
/// would only take time.
constexpr double SlowestCoarsening = 0.7;
/// It ends where the levels would have more entries than this, in parts of the entries of the
/// finest.
constexpr double MostComplexity = 3.0;
/// A level has at least this many rows where it is to hold eigenvectors.
constexpr Index FewestRows = 8;
/// With more rows than this, the storage of the pieces that coarse levels were made of is returned
/// to the system: it would count towards the peak of the next stage.
constexpr Index ManyRows = 1 << 20;

/// Of all couplings this part may have no mass: its integrals may happen to cancel.
constexpr double MostWithoutMass = 0.1;

/// The numbers of couplings, and of those whose mass is zero.
struct CouplingCounts
{
  Index All = 0;
  Index WithoutMass = 0;
  CouplingCounts& operator+=(const CouplingCounts& other)
  {
    this->All += other.All;
    this->WithoutMass += other.WithoutMass;
    return *this;
  }
};

CouplingCounts CountCouplings(const Operators& operators)
{
  const SparseColumns energy(operators.Energy);
  const Complex* const mass = operators.Mass.valuePtr();
  return ParallelSum<CouplingCounts>(static_cast<Index>(operators.Energy.cols()),
    CompactMatrix::PieceRows, {},
    [&](Index begin, Index end)
    {
      CouplingCounts counts;
      counts.All = energy.Begin[end] - energy.Begin[begin] - (end - begin);
      for (Index k = energy.Begin[begin]; k < energy.Begin[end]; ++k)
      {
        counts.WithoutMass += mass[k] == 0.0 && energy.Value[k] != 0.0 ? 1 : 0;
      }
      return counts;
    });
}

bool HaveOnePattern(const SparseMatrix& a, const SparseMatrix& b)
{
  return a.isCompressed() && b.isCompressed() && a.cols() == b.cols() &&
    a.nonZeros() == b.nonZeros() &&
    std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
    std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Throws std::invalid_argument where the operators break a promise of Operators.
void RequireTransport(const Operators& operators)
{
  const char* const advice =
    " Multigrid reads the parallel transport of sections off the phases of the mass "
    "matrix. Do not lump it: assemble it with an entry of its own for each edge.";
  if (!HaveOnePattern(operators.Energy, operators.Mass))
  {
    throw std::invalid_argument(
      std::string("Energy and mass matrix have entries at different places.") + advice);
  }
  const CouplingCounts counts = CountCouplings(operators);
  if (counts.WithoutMass > MostWithoutMass * counts.All)
  {
    throw std::invalid_argument("The mass matrix is zero at " + std::to_string(counts.WithoutMass) +
      " of the " + std::to_string(counts.All) + " places where the energy couples two vertices." +
      advice);
  }
}

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
  RequireTransport(operators);
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
    const Index fewest = leftOver == LeftOver::Keep ? FewestRows : 1;
    if (prolongator.CoarseRows() > SlowestCoarsening * level.Rows() ||
      prolongator.CoarseRows() < fewest || this->OperatorComplexity() > MostComplexity)
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
