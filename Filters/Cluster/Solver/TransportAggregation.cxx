// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/TransportAggregation.h"

#include "Multigrid/Aggregation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
/// As in Multigrid/SmoothedAggregation: damping over the largest eigenvalue, the threshold of
/// strong entries, its decay from level to level, and the part of the diagonal that lumping leaves.
constexpr double Damping = 4.0 / 3.0;
constexpr double StrongPart = 0.08;
constexpr double StrongPartDecay = 0.7;
constexpr double LeastFilteredDiagonal = 0.3;

/// Compressed rows of a block of a distributed matrix, as long as this lives.
class BlockRows
{
public:
  explicit BlockRows(Mat block)
    : Block(block)
  {
    PetscBool done = PETSC_FALSE;
    Require(MatGetRowIJ(
      block, 0, PETSC_FALSE, PETSC_FALSE, &this->Count, &this->Begin, &this->Columns, &done));
    Require(MatSeqAIJGetArrayRead(block, &this->Values));
  }
  ~BlockRows()
  {
    PetscBool done = PETSC_FALSE;
    MatSeqAIJRestoreArrayRead(this->Block, &this->Values);
    MatRestoreRowIJ(
      this->Block, 0, PETSC_FALSE, PETSC_FALSE, &this->Count, &this->Begin, &this->Columns, &done);
  }
  BlockRows(const BlockRows&) = delete;
  BlockRows& operator=(const BlockRows&) = delete;

  PetscInt Count = 0;
  const PetscInt* Begin = nullptr;
  const PetscInt* Columns = nullptr;
  const PetscScalar* Values = nullptr;

private:
  Mat Block;
};

/// The blocks of the own rows: columns of this process, and columns of others.
struct Blocks
{
  explicit Blocks(Mat matrix)
  {
    Require(MatMPIAIJGetSeqAIJ(matrix, &this->Own, &this->Others, &this->Columns));
    Require(MatGetSize(this->Others, nullptr, &this->OtherColumns));
  }
  Mat Own = nullptr;
  Mat Others = nullptr;
  /// The column of the whole for each of the others' columns.
  const PetscInt* Columns = nullptr;
  PetscInt OtherColumns = 0;
};

/// Brings values of rows to the processes that have columns of them.
class ColumnValues
{
public:
  ColumnValues(Mat matrix, const Blocks& blocks)
    : Communicator(PetscObjectComm(reinterpret_cast<PetscObject>(matrix)))
  {
    Require(MatCreateVecs(matrix, nullptr, this->Rows.New()));
    Require(VecCreateSeq(PETSC_COMM_SELF, blocks.OtherColumns, this->Others.New()));
    OwnedIndices indices;
    Require(ISCreateGeneral(
      PETSC_COMM_SELF, blocks.OtherColumns, blocks.Columns, PETSC_COPY_VALUES, indices.New()));
    Require(VecScatterCreate(this->Rows, indices, this->Others, nullptr, this->Scatter.New()));
  }

  std::vector<PetscScalar> Of(const std::vector<PetscScalar>& own)
  {
    PetscScalar* values = nullptr;
    Require(VecGetArray(this->Rows, &values));
    std::copy(own.begin(), own.end(), values);
    Require(VecRestoreArray(this->Rows, &values));
    Require(
      VecScatterBegin(this->Scatter, this->Rows, this->Others, INSERT_VALUES, SCATTER_FORWARD));
    Require(VecScatterEnd(this->Scatter, this->Rows, this->Others, INSERT_VALUES, SCATTER_FORWARD));
    PetscInt count = 0;
    Require(VecGetLocalSize(this->Others, &count));
    const PetscScalar* received = nullptr;
    Require(VecGetArrayRead(this->Others, &received));
    std::vector<PetscScalar> others;
    DoOnAll(this->Communicator, [&] { others.assign(received, received + count); });
    Require(VecRestoreArrayRead(this->Others, &received));
    return others;
  }

private:
  MPI_Comm Communicator;
  OwnedVec Rows;
  OwnedVec Others;
  OwnedScatter Scatter;
};

SparseMatrix ToCore(const BlockRows& rows)
{
  SparseMatrix matrix(static_cast<Index>(rows.Count), static_cast<Index>(rows.Count));
  const PetscInt entries = rows.Begin[rows.Count];
  matrix.resizeNonZeros(static_cast<Index>(entries));
  std::copy_n(rows.Begin, rows.Count + 1, matrix.outerIndexPtr());
  std::copy_n(rows.Columns, entries, matrix.innerIndexPtr());
  // A row of a Hermitian matrix is the conjugate of the column.
  std::transform(rows.Values, rows.Values + entries, matrix.valuePtr(),
    [](const PetscScalar& value) { return std::conj(value); });
  return matrix;
}

/// Aggregates of the own rows, as LinearAlgebra makes them (Multigrid/Aggregation).
Aggregates AggregateOwn(const BlockRows& energy, const BlockRows& mass, int level)
{
  LevelMatrices matrices;
  matrices.Energy = CompactMatrix(ToCore(energy));
  CompactMatrix massMatrix(ToCore(mass));
  matrices.MassValue = std::move(massMatrix.Value);
  matrices.MassDiagonal = std::move(massMatrix.Diagonal);
  return Aggregate(matrices, FindCouplings(matrices, level), LeftOver::Keep);
}

/// Rows of the prolongator, one after the other.
struct ProlongatorRows
{
  std::vector<PetscInt> Begin = { 0 };
  std::vector<PetscInt> Columns;
  std::vector<PetscScalar> Values;
};

/// The data that a row needs of its columns: the diagonal of the energy, the aggregate and its
/// phase.
struct ColumnData
{
  std::vector<PetscScalar> Diagonal;
  std::vector<PetscScalar> Aggregate;
  std::vector<PetscScalar> Phase;
};

/// One row of (1 - damping / radius * filtered energy) times the aggregates.
class RowSmoother
{
public:
  RowSmoother(double strongPart, double diagonal)
    : SquaredPart(strongPart * strongPart * diagonal)
    , Filtered(diagonal)
  {
  }

  void Add(
    const PetscScalar& energy, const PetscScalar& mass, std::size_t column, const ColumnData& data)
  {
    const double size = std::abs(mass);
    const PetscScalar transport = size > 0.0 ? mass / size : PetscScalar(1.0);
    const double along = (energy * std::conj(transport)).real();
    const bool strong =
      along < 0.0 && along * along > this->SquaredPart * data.Diagonal[column].real();
    if (!strong)
    {
      this->Filtered += along;
      return;
    }
    this->Radius += std::abs(energy);
    this->Sums[static_cast<PetscInt>(data.Aggregate[column].real())] += energy * data.Phase[column];
  }

  void Finish(
    double diagonal, const PetscScalar& aggregate, const PetscScalar& phase, ProlongatorRows& rows)
  {
    const double filtered = std::max(this->Filtered, LeastFilteredDiagonal * diagonal);
    const double step = Damping / (filtered + this->Radius);
    for (auto& [column, value] : this->Sums)
    {
      value *= -step;
    }
    this->Sums[static_cast<PetscInt>(aggregate.real())] += (1.0 - step * filtered) * phase;
    for (const auto& [column, value] : this->Sums)
    {
      rows.Columns.push_back(column);
      rows.Values.push_back(value);
    }
    rows.Begin.push_back(static_cast<PetscInt>(rows.Columns.size()));
  }

private:
  double SquaredPart;
  double Filtered;
  double Radius = 0.0;
  std::map<PetscInt, PetscScalar> Sums;
};
}

OwnedMat MakeProlongator(Mat energy, Mat mass, int level)
{
  const Blocks energyBlocks(energy);
  const Blocks massBlocks(mass);
  const BlockRows own(energyBlocks.Own);
  const BlockRows ownMass(massBlocks.Own);
  const BlockRows others(energyBlocks.Others);
  const BlockRows othersMass(massBlocks.Others);
  MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(energy));
  Aggregates aggregates;
  DoOnAll(communicator, [&] { aggregates = AggregateOwn(own, ownMass, level); });
  auto count = static_cast<PetscInt>(aggregates.Count);
  PetscInt end = 0;
  MPI_Scan(&count, &end, 1, MPIU_INT, MPI_SUM, communicator);
  PetscInt total = 0;
  MPI_Allreduce(&count, &total, 1, MPIU_INT, MPI_SUM, communicator);

  ColumnData here;
  const auto describeOwn = [&]
  {
    for (PetscInt i = 0; i < own.Count; ++i)
    {
      for (PetscInt k = own.Begin[i]; k < own.Begin[i + 1]; ++k)
      {
        if (own.Columns[k] == i)
        {
          here.Diagonal.push_back(own.Values[k]);
        }
      }
      here.Aggregate.emplace_back(static_cast<double>(end - count + aggregates.Number[i]));
      here.Phase.emplace_back(aggregates.Phase[i]);
    }
  };
  DoOnAll(communicator, describeOwn);
  ColumnValues exchange(energy, energyBlocks);
  const ColumnData there{ exchange.Of(here.Diagonal), exchange.Of(here.Aggregate),
    exchange.Of(here.Phase) };
  ProlongatorRows rows;
  const double part = StrongPart * std::pow(StrongPartDecay, level);
  const auto smooth = [&]
  {
    for (PetscInt i = 0; i < own.Count; ++i)
    {
      const double diagonal = here.Diagonal[i].real();
      RowSmoother row(part, diagonal);
      for (PetscInt k = own.Begin[i]; k < own.Begin[i + 1]; ++k)
      {
        if (own.Columns[k] != i)
        {
          row.Add(own.Values[k], ownMass.Values[k], own.Columns[k], here);
        }
      }
      for (PetscInt k = others.Begin[i]; k < others.Begin[i + 1]; ++k)
      {
        row.Add(others.Values[k], othersMass.Values[k], others.Columns[k], there);
      }
      row.Finish(diagonal, here.Aggregate[i], here.Phase[i], rows);
    }
  };
  DoOnAll(communicator, smooth);
  OwnedMat prolongator;
  Require(MatCreateMPIAIJWithArrays(communicator, own.Count, count, PETSC_DETERMINE, total,
    rows.Begin.data(), rows.Columns.data(), rows.Values.data(), prolongator.New()));
  return prolongator;
}
}
