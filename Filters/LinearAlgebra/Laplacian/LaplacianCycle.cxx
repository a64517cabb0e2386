// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Laplacian/LaplacianCycle.h"

#include "Support/Threads.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index BlockRows = SweptLaplacian::BlockRows;
constexpr Index PieceRows = SweptLaplacian::PieceRows;
/// How far sweeps go towards the solution of each row.
constexpr float Relaxation = 1.15F;
/// From this level on cycles correct twice: they lose little there, and it costs next to nothing.
constexpr std::size_t FirstTwice = 2;
/// A level with more rows than this is not factored, but swept.
constexpr Index MostDenseRows = 400;
/// The pairs of sweeps that it gets.
constexpr int CoarsestPairs = 4;
/// A level that would add more than this part of the finest level's entries to a cycle is visited
/// once.
constexpr double MostRepeatedPart = 0.15;
}

LaplacianCycle::LaplacianCycle(const LaplacianHierarchy& hierarchy, double shift)
  : Levels(hierarchy.GetLevels())
  , Kept(this->Levels.size())
{
  double visits = 1.0;
  for (std::size_t l = 0; l < this->Levels.size(); ++l)
  {
    const SweptLaplacian& matrix = this->Levels[l].Matrix;
    const auto rows = static_cast<std::size_t>(matrix.Rows());
    Storage& own = this->Kept[l];
    own.Diagonal.resize(rows);
    own.Inverse.resize(rows);
    own.Excess.resize(rows);
    // Sums read values that are not there yet, and multiply them by zero: they must be finite.
    own.Rest.resize(rows, 0.0F);
    own.Before.resize(rows, 0.0F);
    if (l > 0)
    {
      own.Right.resize(rows);
      own.Up.resize(rows, 0.0F);
      own.Left.resize(rows);
    }
    own.IsRepeated = l >= FirstTwice && l + 1 < this->Levels.size() &&
      visits * matrix.Entries() <= MostRepeatedPart * this->Levels.front().Matrix.Entries();
    visits *= own.IsRepeated ? 2.0 : 1.0;
    ParallelFor(matrix.Rows(), PieceRows,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          own.Diagonal[v] =
            matrix.Diagonal[v] + static_cast<float>(shift) * this->Levels[l].Mass[v];
          float sum = own.Diagonal[v];
          for (Index k = matrix.Inside[v]; k < matrix.Begin[v + 1]; ++k)
          {
            sum += std::abs(matrix.Weight[k]);
          }
          own.Inverse[v] = sum > 0.0F ? Relaxation / sum : 0.0F;
          own.Excess[v] = sum / Relaxation - own.Diagonal[v];
        }
      });
  }
  if (this->Levels.back().Matrix.Rows() <= MostDenseRows)
  {
    this->Factor(shift);
  }
}

void LaplacianCycle::Factor(double shift)
{
  const SweptLaplacian& matrix = this->Levels.back().Matrix;
  const Index n = matrix.Rows();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
  {
    dense(i, i) = this->Kept.back().Diagonal[i];
    for (Index k = matrix.Begin[i]; k < matrix.Begin[i + 1]; ++k)
    {
      dense(i, matrix.Column[k]) -= matrix.Weight[k];
    }
  }
  dense = (0.5 * (dense + dense.transpose())).eval();
  if (shift == 0.0)
  {
    // Constants are in the kernel of the Laplacian: a term added for them keeps the matrix
    // definite.
    dense.array() += dense.trace() / (static_cast<double>(n) * n);
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(dense);
  this->Usable = factor.info() == Eigen::Success && factor.matrixLLT().allFinite();
  this->DenseFactor = factor.matrixLLT();
}

void LaplacianCycle::SolveCoarsest(const float* b, float* y) const
{
  const Eigen::Index n = this->DenseFactor.rows();
  Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXf>(b, n).cast<double>();
  const auto lower = this->DenseFactor.triangularView<Eigen::Lower>();
  lower.solveInPlace(solution);
  lower.adjoint().solveInPlace(solution);
  Eigen::Map<Eigen::VectorXf>(y, n) = solution.cast<float>();
}

void LaplacianCycle::Apply(const LargeArray<float>& b, LargeArray<float>& y)
{
  y.assign(b.size(), 0.0F);
  this->Apply(0, b.data(), y.data());
}

void LaplacianCycle::Apply(std::size_t level, const float* b, float* y)
{
  Storage& own = this->Kept[level];
  if (level + 1 == this->Levels.size())
  {
    if (this->DenseFactor.size() > 0)
    {
      this->SolveCoarsest(b, y);
      return;
    }
    this->SweepDown(level, b, y, own.Rest.data());
    for (int pair = 1; pair < CoarsestPairs; ++pair)
    {
      this->SweepUp(level, b, y);
      this->FindRest(level, b, y, own.Rest.data());
      this->SweepDown(level, own.Rest.data(), own.Before.data(), own.Rest.data());
      std::transform(own.Before.begin(), own.Before.end(), y, y, std::plus<>());
    }
    this->SweepUp(level, b, y);
    return;
  }
  const NumberProlongator& fromCoarser = this->Levels[level].FromCoarser;
  Storage& coarser = this->Kept[level + 1];
  this->SweepDown(level, b, y, own.Rest.data());
  fromCoarser.Restrict(own.Rest.data(), coarser.Right.data());
  this->Apply(level + 1, coarser.Right.data(), coarser.Up.data());
  fromCoarser.AddTo(y, coarser.Up.data());
  if (coarser.IsRepeated)
  {
    this->FindRest(level + 1, coarser.Right.data(), coarser.Up.data(), coarser.Left.data());
    this->Apply(level + 1, coarser.Left.data(), coarser.Up.data());
    fromCoarser.AddTo(y, coarser.Up.data());
  }
  this->SweepUp(level, b, y);
}

void LaplacianCycle::SweepDown(std::size_t level, const float* b, float* x, float* r) const
{
  const SweptLaplacian& matrix = this->Levels[level].Matrix;
  ParallelFor(matrix.Rows(), BlockRows,
    [b, x, begins = matrix.Begin.data(), lower = matrix.Lower.data(),
      columns = matrix.Column.data(), weights = matrix.Weight.data(),
      inverse = this->Kept[level].Inverse.data()](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        x[v] = (b[v] + SumOfProducts(weights, columns, begins[v], lower[v], x)) * inverse[v];
      }
    });
  ParallelFor(matrix.Rows(), BlockRows,
    [x, r, lower = matrix.Lower.data(), begins = matrix.Begin.data(),
      columns = matrix.Column.data(), weights = matrix.Weight.data(),
      excess = this->Kept[level].Excess.data()](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        r[v] = excess[v] * x[v] + SumOfProducts(weights, columns, lower[v], begins[v + 1], x);
      }
    });
}

void LaplacianCycle::SweepUp(std::size_t level, const float* b, float* x)
{
  const SweptLaplacian& matrix = this->Levels[level].Matrix;
  float* const before = this->Kept[level].Before.data();
  ParallelFor(matrix.Rows(), PieceRows,
    [x, before](Index begin, Index end) { std::copy(x + begin, x + end, before + begin); });
  ParallelFor(matrix.Rows(), BlockRows,
    [b, x, before, begins = matrix.Begin.data(), inside = matrix.Inside.data(),
      columns = matrix.Column.data(), weights = matrix.Weight.data(),
      diagonal = this->Kept[level].Diagonal.data(),
      inverse = this->Kept[level].Inverse.data()](Index begin, Index end)
    {
      for (Index v = end; v-- > begin;)
      {
        const float own = SumOfProducts(weights, columns, begins[v], inside[v], x);
        const float others = SumOfProducts(weights, columns, inside[v], begins[v + 1], before);
        x[v] += (b[v] - diagonal[v] * x[v] + own + others) * inverse[v];
      }
    });
}

void LaplacianCycle::FindRest(std::size_t level, const float* b, const float* x, float* r) const
{
  const SweptLaplacian& matrix = this->Levels[level].Matrix;
  ParallelFor(matrix.Rows(), PieceRows,
    [b, x, r, begins = matrix.Begin.data(), columns = matrix.Column.data(),
      weights = matrix.Weight.data(),
      diagonal = this->Kept[level].Diagonal.data()](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        r[v] =
          b[v] - diagonal[v] * x[v] + SumOfProducts(weights, columns, begins[v], begins[v + 1], x);
      }
    });
}
}
