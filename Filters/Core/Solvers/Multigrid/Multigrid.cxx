// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Multigrid/Multigrid.h"

#include "Support/Threads.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields
{
namespace
{
/// Coarsening ends where a level would have more than this part of the rows of the finer one, and that
/// could be factored.
constexpr double SlowestCoarsening = 0.7;
/// It ends anyway where a level would have more than this part.
constexpr double NoCoarsening = 0.95;
/// A level has at least this many rows where it is to hold eigenvectors.
constexpr Index FewestRows = 8;
/// Rows that the factor of the coarsest level may have where coarsening ends early.
constexpr Index MostCoarsestRows = 1500;
/// Added to the coarsest energy, relative to the scale of its smallest eigenvalue: that may be 0.
constexpr double AddedShift = 0.01;
/// From this level on cycles correct twice: they lose little there, where a hierarchy of many levels
/// would lose much, and it costs next to nothing.
constexpr std::size_t FirstTwice = 2;

/// Of so many rows on, the pieces that coarse levels were made of are worth returning.
constexpr Index ManyRows = 1 << 20;

/// Of the sweeps.
constexpr float Relaxation = 1.15f;

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

Multigrid::Multigrid(const Operators& operators, double scale, LeftOver leftOver)
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
      // That of the operators will do.
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

double Multigrid::OperatorComplexity() const
{
  double entries = 0.0;
  for (const Level& level : this->Levels)
  {
    entries += static_cast<double>(level.Matrices.Energy.Entries()) + level.Rows();
  }
  const Level& finest = this->Levels.front();
  return entries / (static_cast<double>(finest.Matrices.Energy.Entries()) + finest.Rows());
}

Cycle::Cycle(const Multigrid& hierarchy, double shift)
  : Hierarchy(hierarchy)
  , Shift(static_cast<float>(shift))
  , CoarsestShift(shift + AddedShift * hierarchy.GetScale())
{
  const std::vector<Multigrid::Level>& levels = hierarchy.GetLevels();
  for (std::size_t l = 0; l + 1 < levels.size(); ++l)
  {
    this->Diagonals.emplace_back(
      levels[l].Matrices.Energy, levels[l].LumpedMass, this->Shift, Relaxation);
  }
  this->Workspaces.resize(levels.size());

  const LevelMatrices& coarsest = levels.back().Matrices;
  const CompactMatrix& energy = coarsest.Energy;
  const Index n = energy.Rows();
  if (n > 2 * MostCoarsestRows)
  {
    return;
  }
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
  {
    matrix(i, i) = energy.Diagonal[i] + this->CoarsestShift * coarsest.MassDiagonal[i];
    for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
    {
      matrix(i, energy.Column[k]) =
        Complex(energy.Value[k]) + this->CoarsestShift * Complex(coarsest.MassValue[k]);
    }
  }
  const Eigen::LLT<Eigen::MatrixXcd> factor(matrix);
  this->Usable = factor.info() == Eigen::Success && factor.matrixLLT().allFinite();
  this->CoarsestFactor = factor.matrixLLT();
}

template <int B>
void Cycle::SolveCoarsest(const float* b, float* y, double* product) const
{
  const auto n = static_cast<Index>(this->CoarsestFactor.rows());
  Eigen::Matrix<Complex, Eigen::Dynamic, B> solution(n, B);
  for (Index v = 0; v < n; ++v)
  {
    for (int k = 0; k < B; ++k)
    {
      solution(v, k) = Complex(b[2 * B * v + k], b[2 * B * v + B + k]);
    }
  }
  const auto lower = this->CoarsestFactor.triangularView<Eigen::Lower>();
  lower.solveInPlace(solution);
  lower.adjoint().solveInPlace(solution);
  for (Index v = 0; v < n; ++v)
  {
    for (int k = 0; k < B; ++k)
    {
      y[2 * B * v + k] = static_cast<float>(solution(v, k).real());
      y[2 * B * v + B + k] = static_cast<float>(solution(v, k).imag());
    }
  }
  if (product)
  {
    *product = std::inner_product(b, b + 2 * B * n, y, 0.0);
  }
}

template <int B>
void Cycle::Apply(const float* b, float* y, std::size_t level, double* product) const
{
  const std::vector<Multigrid::Level>& levels = this->Hierarchy.GetLevels();
  if (level + 1 == levels.size())
  {
    this->SolveCoarsest<B>(b, y, product);
    return;
  }
  const CompactMatrix& matrix = levels[level].Matrices.Energy;
  const Prolongator& fromCoarser = levels[level].FromCoarser;
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
  if (level + 1 >= FirstTwice && level + 2 < levels.size())
  {
    this->ApplyAgain<B>(level + 1);
  }
  fromCoarser.AddTo<B>(y, coarser.Up.data());
  Sweep<B>(matrix, this->Diagonals[level], SweepOrder::Up, b, y, nullptr, product);
}

template <int B>
void Cycle::ApplyAgain(std::size_t level) const
{
  const Multigrid::Level& matrices = this->Hierarchy.GetLevels()[level];
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
