// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Cycle.h"

#include "Support/Threads.h"

namespace DirectionFields::Internal
{
namespace
{
/// Added to the coarsest energy, relative to the scale of its smallest eigenvalue: that may be 0.
constexpr double AddedShift = 0.01;
/// From this level on cycles correct twice: they lose little there, where a hierarchy of many
/// levels would lose much, and it costs next to nothing. It does not where levels get smaller
/// slowly: a level whose visits would come by more entries than this part of the finest level's is
/// visited no more often.
constexpr std::size_t FirstTwice = 2;
constexpr double MostRepeatedPart = 0.3;

/// The work of a cycle for each entry that it comes by (see WorkLimit): a sweep down, the residual,
/// a sweep up and the prolongators between the levels.
constexpr double WorkPerEntry = 4.3;

/// The number of entries, the diagonal's among them.
double Entries(const Hierarchy::Level& level)
{
  return static_cast<double>(level.Matrices.Energy.Entries()) + level.Rows();
}
/// How far sweeps go towards the solution of each row.
constexpr float Relaxation = 1.15f;
}

Cycle::Cycle(const Hierarchy& hierarchy, double shift)
  : Levels(hierarchy.GetLevels())
  , Shift(static_cast<float>(shift))
  , CoarsestShift(shift + AddedShift * hierarchy.GetScale())
  , Coarsest(hierarchy.GetLevels().back().Matrices, hierarchy.GetLevels().back().LumpedMass,
      this->CoarsestShift)
  , Visits(hierarchy.GetLevels().size(), 1)
{
  for (std::size_t l = 0; l + 1 < this->Levels.size(); ++l)
  {
    this->Diagonals.emplace_back(
      this->Levels[l].Matrices.Energy, this->Levels[l].LumpedMass, this->Shift, Relaxation);
  }
  for (std::size_t l = 1; l < this->Levels.size(); ++l)
  {
    const bool mayRepeat = l >= FirstTwice && l + 1 < this->Levels.size();
    const int repeated = 2 * this->Visits[l - 1];
    const bool repeats = mayRepeat &&
      repeated * Entries(this->Levels[l]) <= MostRepeatedPart * Entries(this->Levels.front());
    this->Visits[l] = repeats ? repeated : this->Visits[l - 1];
  }
  this->Workspaces.resize(this->Levels.size());
}

double Cycle::Work() const
{
  double entries = 0.0;
  for (std::size_t l = 0; l + 1 < this->Levels.size(); ++l)
  {
    entries += this->Visits[l] * Entries(this->Levels[l]);
  }
  // A factor has half as many entries as a square, and each solution goes through it twice.
  const double rows = this->Levels.back().Rows();
  entries += this->Visits.back() *
    (this->Coarsest.GetPairs() > 0 ? this->Coarsest.GetPairs() * Entries(this->Levels.back())
                                   : 0.3 * rows * rows);
  return WorkPerEntry * entries;
}

template <int B>
void Cycle::Apply(const float* b, float* y, std::size_t level, double* product) const
{
  if (level + 1 == this->Levels.size())
  {
    this->Coarsest.Solve<B>(b, y, product);
    return;
  }
  const CompactMatrix& matrix = this->Levels[level].Matrices.Energy;
  const Prolongator& fromCoarser = this->Levels[level].FromCoarser;
  Workspace& own = this->Workspaces[level];
  Workspace& coarser = this->Workspaces[level + 1];
  const std::size_t fine = static_cast<std::size_t>(2 * B) * matrix.Rows();
  const std::size_t coarse = static_cast<std::size_t>(2 * B) * fromCoarser.CoarseRows();
  if (own.Rest.size() < fine)
  {
    own.Rest.resize(fine);
  }
  if (coarser.Right.size() < coarse)
  {
    coarser.Right.resize(coarse);
    coarser.Up.resize(coarse);
  }
  SweepFromZero<B>(matrix, this->Diagonals[level], b, y, own.Rest.data());
  fromCoarser.Restrict<B>(own.Rest.data(), coarser.Right.data());
  this->Apply<B>(coarser.Right.data(), coarser.Up.data(), level + 1);
  if (this->Visits[level + 1] > this->Visits[level])
  {
    this->ApplyAgain<B>(level + 1);
  }
  fromCoarser.AddTo<B>(y, coarser.Up.data());
  Sweep<B>(matrix, this->Diagonals[level], SweepOrder::Up, b, y, nullptr, product);
}

template <int B>
void Cycle::ApplyAgain(std::size_t level) const
{
  const Hierarchy::Level& matrices = this->Levels[level];
  Workspace& own = this->Workspaces[level];
  own.Once.resize(own.Up.size());
  own.Once.swap(own.Up);
  ParallelFor(matrices.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> product = matrices.Matrices.Energy.RowTimes<B>(v, own.Once.data());
        product.AddReal(this->Shift * matrices.LumpedMass[v], own.Once.data(), v);
        product.Scale(-1.0f);
        product.AddReal(1.0f, own.Right.data(), v);
        product.Store(own.Right.data(), v);
      }
    });
  this->Apply<B>(own.Right.data(), own.Up.data(), level);
  ParallelFor(matrices.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> sum(own.Up.data(), v);
        sum.AddReal(1.0f, own.Once.data(), v);
        sum.Store(own.Up.data(), v);
      }
    });
}

template void Cycle::Apply<1>(const float*, float*, std::size_t, double*) const;
template void Cycle::Apply<4>(const float*, float*, std::size_t, double*) const;
}
