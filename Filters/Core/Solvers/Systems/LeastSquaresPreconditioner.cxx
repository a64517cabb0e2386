// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/LeastSquaresPreconditioner.h"

#include "Solvers/Matrices/SparseColumns.h"
#include "Solvers/Matrices/SparseProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Support/Free.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The sweeps of a cycle on each level, and the factor by which each of them goes beyond its correction.
constexpr int Sweeps = 3;
constexpr float Relaxation = 1.2f;
/// The coarse level has at most this number of unknowns: more of them save steps, but cost more in each.
constexpr Index MostCoarseRows = 30000;
/// The coarse matrix is not formed where it would couple an unknown with more others than this in the mean.
constexpr double DensestCouplings = 100.0;
/// The sections of the coarse level that reach given vertices are deflated. So are the sections that reach
/// the vertices of these, and so on for this number of layers.
constexpr int Layers = 2;
constexpr Index ColumnPiece = 256;

/// The prolongator P as a sparse matrix.
/// @param free if given, row k of P becomes the row of the k-th free vertex among all vertices
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

/// Also marks the rows that a matrix couples with marked ones.
void Widen(const SparseMatrix& matrix, std::vector<char>& rows)
{
  const std::vector<char> before = rows;
  for (Index v = 0; v < static_cast<Index>(before.size()); ++v)
  {
    if (before[v])
    {
      for (SparseMatrix::InnerIterator it(matrix, v); it; ++it)
      {
        rows[it.row()] = 1;
      }
    }
  }
}

/// The columns of K Z that reach marked rows, or rows that such columns reach, and so on for all layers.
std::vector<Index> ColumnsNear(
  const SparseMatrix& matrix, const SparseMatrix& sections, std::vector<char> rows)
{
  std::vector<Index> near;
  for (int layer = 0; layer <= Layers; ++layer)
  {
    // K Z reaches them where Z reaches these.
    Widen(matrix, rows);
    near.clear();
    for (Index column = 0; column < sections.cols(); ++column)
    {
      bool reaches = false;
      for (SparseMatrix::InnerIterator it(sections, column); it && !reaches; ++it)
      {
        reaches = rows[it.row()] != 0;
      }
      if (reaches)
      {
        near.push_back(column);
      }
    }
    for (const Index column : near)
    {
      for (SparseMatrix::InnerIterator it(sections, column); it; ++it)
      {
        rows[it.row()] = 1;
      }
    }
    Widen(matrix, rows);
  }
  return near;
}

/// W^* y
ComplexVector AdjointTimes(const SparseMatrix& w, const ComplexVector& y)
{
  ComplexVector products(w.cols());
  ParallelFor(static_cast<Index>(w.cols()), ColumnPiece,
    [columns = SparseColumns(w), from = y.data(), to = products.data()](Index begin, Index end)
    {
      for (Index column = begin; column < end; ++column)
      {
        to[column] = columns.AdjointTimes(column, from);
      }
    });
  return products;
}
}

LeastSquaresPreconditioner::SparseRows::SparseRows(const SparseMatrix& matrix)
  : Adjoint(matrix.adjoint())
{
  for (Index row = 0; row < this->Adjoint.cols(); ++row)
  {
    if (this->Adjoint.outerIndexPtr()[row] < this->Adjoint.outerIndexPtr()[row + 1])
    {
      this->Filled.push_back(row);
    }
  }
}

void LeastSquaresPreconditioner::SparseRows::SubtractProduct(
  const ComplexVector& c, ComplexVector& y) const
{
  ParallelFor(static_cast<Index>(this->Filled.size()), ColumnPiece,
    [rows = SparseColumns(this->Adjoint), filled = this->Filled.data(), from = c.data(),
      to = y.data()](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        to[filled[k]] -= rows.AdjointTimes(filled[k], from);
      }
    });
}

LeastSquaresPreconditioner::LeastSquaresPreconditioner(const SparseMatrix& matrix,
  const std::vector<Index>& free, const Hierarchy& hierarchy, double shift)
  : Free(free)
  , Multigrid(hierarchy)
  , Coarsest(hierarchy, shift)
{
  for (const Hierarchy::Level& level : hierarchy.GetLevels())
  {
    Workspace own;
    own.Diagonal =
      SweepDiagonal(level.Matrices.Energy, level.LumpedMass, static_cast<float>(shift), Relaxation);
    for (CompactSections* section : { &own.Right, &own.Sum, &own.Rest })
    {
      section->resize(2 * static_cast<std::size_t>(level.Rows()));
    }
    this->Levels.push_back(std::move(own));
  }
  this->MakeCoarse(matrix);
}

void LeastSquaresPreconditioner::MakeCoarse(const SparseMatrix& matrix)
{
  const std::vector<Hierarchy::Level>& levels = this->Multigrid.GetLevels();
  std::size_t level = 1;
  while (level < levels.size() && levels[level].Rows() > MostCoarseRows)
  {
    ++level;
  }
  if (level >= levels.size())
  {
    return;
  }
  const auto count = static_cast<Index>(matrix.cols());
  SparseMatrix sections = ToSparse(levels[0].FromCoarser, count, &this->Free);
  for (std::size_t l = 1; l < level; ++l)
  {
    sections = SparseProduct(sections, ToSparse(levels[l].FromCoarser, levels[l].Rows(), nullptr));
  }
  std::vector<char> isGiven(count, 1);
  for (const Index v : this->Free)
  {
    isGiven[v] = 0;
  }
  sections = SelectedColumns(sections, ColumnsNear(matrix, sections, std::move(isGiven)));
  if (sections.cols() == 0)
  {
    return;
  }
  SparseMatrix columns = SparseProduct(matrix, sections);
  SparseRows rows(columns);
  if (IsNormalMatrixSparse(rows.Adjoint, DensestCouplings) &&
    this->CoarseFactor.Compute(SparseProduct(rows.Adjoint, columns)))
  {
    // Eigen's sparse matrices copy where they are assigned from temporaries.
    this->CoarseColumns.swap(columns);
    this->CoarseRows = std::move(rows);
    this->Sections = SparseRows(sections);
    this->Deflates = true;
  }
}

void LeastSquaresPreconditioner::ApplyCycle(std::size_t level, bool after)
{
  Workspace& own = this->Levels[level];
  if (level + 1 == this->Levels.size())
  {
    this->Coarsest.Apply<1>(own.Right.data(), own.Sum.data(), level);
    return;
  }
  const Hierarchy::Level& matrices = this->Multigrid.GetLevels()[level];
  const CompactMatrix& matrix = matrices.Matrices.Energy;
  const float* const right = own.Right.data();
  float* const x = own.Sum.data();
  Workspace& coarser = this->Levels[level + 1];
  if (after)
  {
    matrices.FromCoarser.Restrict<1>(right, coarser.Right.data());
  }
  else
  {
    SweepFromZero<1>(matrix, own.Diagonal, right, x);
    for (int sweep = 1; sweep < Sweeps; ++sweep)
    {
      Sweep<1>(matrix, own.Diagonal, SweepOrder::Down, right, x,
        sweep + 1 < Sweeps ? nullptr : own.Rest.data());
    }
    matrices.FromCoarser.Restrict<1>(own.Rest.data(), coarser.Right.data());
  }
  this->ApplyCycle(level + 1, after);
  if (!after)
  {
    matrices.FromCoarser.AddTo<1>(x, coarser.Sum.data());
    return;
  }
  matrices.FromCoarser.Prolong<1>(coarser.Sum.data(), x);
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    Sweep<1>(matrix, own.Diagonal, SweepOrder::Up, right, x);
  }
}

double LeastSquaresPreconditioner::Apply(const ComplexVector& r, double size)
{
  const auto count = static_cast<Index>(this->Free.size());
  Workspace& finest = this->Levels.front();
  if (!(size > 0.0))
  {
    return 0.0;
  }
  ParallelFor(count, VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        const Complex value = r[this->Free[k]] / size;
        finest.Right[2 * k] = static_cast<float>(value.real());
        finest.Right[2 * k + 1] = static_cast<float>(value.imag());
      }
    });
  this->ApplyCycle(0, false);
  finest.Right.swap(finest.Sum);
  this->ApplyCycle(0, true);
  return ParallelSum<double>(count, VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      double product = 0.0;
      for (Index k = begin; k < end; ++k)
      {
        const Complex& value = r[this->Free[k]];
        product += value.real() * finest.Sum[2 * k] + value.imag() * finest.Sum[2 * k + 1];
      }
      return size * product;
    });
}

ComplexVector LeastSquaresPreconditioner::Deflate(ComplexVector& y) const
{
  if (!this->Deflates)
  {
    return {};
  }
  ComplexVector c = this->CoarseFactor.Solve(AdjointTimes(this->CoarseColumns, y));
  this->CoarseRows.SubtractProduct(c, y);
  return c;
}

void LeastSquaresPreconditioner::Correct(const ComplexVector& c, ComplexVector& x) const
{
  if (this->Deflates)
  {
    this->Sections.SubtractProduct(c, x);
  }
}
}
