// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Multigrid/Cycle.h"

#include "Support/Threads.h"

#include <Eigen/Cholesky>

#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// Added to the coarsest energy, relative to the scale of its smallest eigenvalue: that may be 0.
constexpr double AddedShift = 0.01;
/// From this level on cycles correct twice: they lose little there, where a hierarchy of many levels
/// would lose much, and it costs next to nothing.
constexpr std::size_t FirstTwice = 2;
/// How far sweeps go towards the solution of each row.
constexpr float Relaxation = 1.15f;
}

Cycle::Cycle(const Hierarchy& hierarchy, double shift)
  : Levels(hierarchy.GetLevels())
  , Shift(static_cast<float>(shift))
  , CoarsestShift(shift + AddedShift * hierarchy.GetScale())
{
  for (std::size_t l = 0; l + 1 < this->Levels.size(); ++l)
  {
    this->Diagonals.emplace_back(
      this->Levels[l].Matrices.Energy, this->Levels[l].LumpedMass, this->Shift, Relaxation);
  }
  this->Workspaces.resize(this->Levels.size());

  const LevelMatrices& coarsest = this->Levels.back().Matrices;
  const CompactMatrix& energy = coarsest.Energy;
  const Index n = energy.Rows();
  if (n > 2 * Hierarchy::MostCoarsestRows)
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
  if (level + 1 == this->Levels.size())
  {
    this->SolveCoarsest<B>(b, y, product);
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
  if (level + 1 >= FirstTwice && level + 2 < this->Levels.size())
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
