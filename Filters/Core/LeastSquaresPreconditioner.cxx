// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LeastSquaresPreconditioner.h"

#include "VectorOperations.h"

#include <utility>

namespace DirectionFields
{
namespace
{
/// Sweeps after a V-cycle, and before its adjoint.
constexpr int Sweeps = 3;
/// Unknowns of the coarse level: more of them save steps, but cost more in each.
constexpr Index MostCoarseRows = 12000;
/// A coarse matrix that couples an unknown with more others than this in the mean is not formed.
constexpr double DensestCouplings = 100.0;
constexpr Index ColumnPiece = 1024;

/// P, or P with its rows moved to the free vertices among all.
SparseMatrix ToSparse(const Prolongator& p, Index rows, const std::vector<Index>* free)
{
  SparseMatrix matrix(rows, p.CoarseRows());
  matrix.reserve(static_cast<Eigen::Index>(p.AdjointValue.size()));
  for (Index column = 0; column < p.CoarseRows(); ++column)
  {
    matrix.startVec(column);
    for (Index k = p.AdjointBegin[column]; k < p.AdjointBegin[column + 1]; ++k)
    {
      const Index row = free ? (*free)[p.AdjointColumn[k]] : p.AdjointColumn[k];
      matrix.insertBack(row, column) = std::conj(Complex(p.AdjointValue[k]));
    }
  }
  matrix.finalize();
  return matrix;
}

/// W^* y, W in compressed columns.
ComplexVector AdjointTimes(const SparseMatrix& w, const ComplexVector& y)
{
  ComplexVector products(w.cols());
  ParallelFor(static_cast<Index>(w.cols()), ColumnPiece,
    [&](Index begin, Index end)
    {
      for (Index column = begin; column < end; ++column)
      {
        Complex sum = 0.0;
        for (SparseMatrix::InnerIterator it(w, column); it; ++it)
        {
          sum += std::conj(it.value()) * y[it.row()];
        }
        products[column] = sum;
      }
    });
  return products;
}

/// P y
ComplexVector Prolonged(const Prolongator& p, const ComplexVector& y)
{
  ComplexVector x(p.FineRows());
  ForRows(x,
    [&](Index begin, Index end)
    {
      for (Index row = begin; row < end; ++row)
      {
        Complex sum = 0.0;
        for (Index k = p.Begin[row]; k < p.Begin[row + 1]; ++k)
        {
          sum += Complex(p.Value[k]) * y[p.Column[k]];
        }
        x[row] = sum;
      }
    });
  return x;
}
}

LeastSquaresPreconditioner::LeastSquaresPreconditioner(const SparseMatrix& matrix,
  const std::vector<Index>& free, const Multigrid& hierarchy, double shift)
  : Free(free)
  , Hierarchy(hierarchy)
  , Cycles(hierarchy, shift)
  , Diagonal(hierarchy.GetLevels()[0].Matrices.Energy, hierarchy.GetLevels()[0].LumpedMass,
      static_cast<float>(shift))
  , Right(2 * free.size())
  , Solution(2 * free.size())
  , Next(2 * free.size())
  , Rest(2 * free.size())
{
  this->MakeCoarse(matrix);
}

void LeastSquaresPreconditioner::MakeCoarse(const SparseMatrix& matrix)
{
  const std::vector<Multigrid::Level>& levels = this->Hierarchy.GetLevels();
  std::size_t level = 1;
  while (level < levels.size() && levels[level].Rows() > MostCoarseRows)
  {
    ++level;
  }
  if (level >= levels.size())
  {
    return;
  }
  SparseMatrix columns = matrix *
    ToSparse(levels[0].FromCoarser, static_cast<Index>(matrix.cols()), &this->Free);
  for (std::size_t l = 1; l < level; ++l)
  {
    columns = SparseMatrix(columns * ToSparse(levels[l].FromCoarser, levels[l].Rows(), nullptr));
  }
  const SparseMatrix adjoint = columns.adjoint();
  double couplings = 0.0;
  for (Eigen::Index row = 0; row < adjoint.outerSize(); ++row)
  {
    const double unknowns = adjoint.outerIndexPtr()[row + 1] - adjoint.outerIndexPtr()[row];
    couplings += unknowns * unknowns;
  }
  if (couplings <= DensestCouplings * static_cast<double>(adjoint.nonZeros()) &&
    this->CoarseFactor.Compute(adjoint * columns))
  {
    this->CoarseColumns = std::move(columns);
    this->CoarseLevel = level;
  }
}

void LeastSquaresPreconditioner::Apply(const ComplexVector& r, ComplexVector& z)
{
  const CompactMatrix& matrix = this->Hierarchy.GetLevels()[0].Matrices.Energy;
  const auto count = static_cast<Index>(this->Free.size());
  const auto numbers = static_cast<Index>(this->Right.size());
  z = ComplexVector::Zero(r.size());
  const double size = Norm(r);
  if (!(size > 0.0))
  {
    return;
  }
  float* const right = this->Right.data();
  float* const solution = this->Solution.data();
  float* const next = this->Next.data();
  float* const rest = this->Rest.data();
  ParallelFor(count, VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        const Complex value = r[this->Free[k]] / size;
        right[2 * k] = static_cast<float>(value.real());
        right[2 * k + 1] = static_cast<float>(value.imag());
      }
    });
  const auto add = [&](const float* what, float* to)
  {
    ParallelFor(numbers, VectorPiece,
      [&](Index begin, Index end)
      {
        for (Index k = begin; k < end; ++k)
        {
          to[k] += what[k];
        }
      });
  };
  // The adjoint: sweeps downwards, then the cycle for what they leave.
  SweepDown<1>(matrix, this->Diagonal, right, solution, rest);
  for (int sweep = 1; sweep < Sweeps; ++sweep)
  {
    this->Right.swap(this->Rest);
    SweepDown<1>(matrix, this->Diagonal, this->Right.data(), next, this->Rest.data());
    add(next, solution);
  }
  this->Cycles.Apply<1>(this->Rest.data(), next);
  add(next, solution);
  // The cycle, then sweeps upwards.
  this->Cycles.Apply<1>(solution, this->Next.data());
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    SweepUp<1>(matrix, this->Diagonal, solution, this->Next.data(), this->Rest.data());
    this->Next.swap(this->Rest);
  }
  ParallelFor(count, VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        z[this->Free[k]] = size * Complex(this->Next[2 * k], this->Next[2 * k + 1]);
      }
    });
}

void LeastSquaresPreconditioner::AddCoarse(double factor, const ComplexVector& y, ComplexVector& x)
{
  if (this->CoarseLevel == 0)
  {
    return;
  }
  ComplexVector section = this->CoarseFactor.Solve(AdjointTimes(this->CoarseColumns, y));
  for (std::size_t level = this->CoarseLevel; level-- > 0;)
  {
    section = Prolonged(this->Hierarchy.GetLevels()[level].FromCoarser, section);
  }
  ParallelFor(static_cast<Index>(this->Free.size()), VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        x[this->Free[k]] += factor * section[k];
      }
    });
}
}
