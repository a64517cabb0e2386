// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/WorkLimit.h"

#include <Eigen/SparseCholesky>

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Measured on surfaces of 2 500 to 200 000 vertices, where they tell the time to a tenth.
constexpr double PerOperation = 0.34;
constexpr double PerFactorEntry = 40.0;
/// Of a solve, which goes through the factor twice.
constexpr double PerSolvedEntry = 7.0;
/// Every iteration may take this much work: less than anybody notices, and more than ordinary
/// surfaces take, whose factors need not be looked at.
constexpr double Unnoticed = 3e7;
constexpr double UnnoticedPerRow = 8000.0;
/// An iteration is judged by its estimated total work once it has had this part of the limit, and
/// ends where that is more than MostForeseen limits: forecasts may be wrong.
constexpr double Trial = 0.3;
constexpr double MostForeseen = 3.0;

/// Knows how many entries the columns of a factor have.
class SymbolicFactor
  : private Eigen::SimplicialLDLT<
      Eigen::SparseMatrix<double, Eigen::ColMajor, SparseMatrix::StorageIndex>>
{
public:
  explicit SymbolicFactor(const SparseMatrix& matrix) { this->analyzePattern(matrix.real()); }
  /// Without the diagonal.
  Eigen::ArrayXd EntriesPerColumn() const
  {
    using Starts = Eigen::Map<const Eigen::Array<SparseMatrix::StorageIndex, Eigen::Dynamic, 1>>;
    const Eigen::Index size = this->m_matrix.cols();
    const SparseMatrix::StorageIndex* starts = this->m_matrix.outerIndexPtr();
    return (Starts(starts + 1, size) - Starts(starts, size)).cast<double>();
  }
};
}

FactorWork::FactorWork(const SparseMatrix& matrix)
  : Rows(static_cast<double>(matrix.rows()))
{
  const Eigen::ArrayXd entries = SymbolicFactor(matrix).EntriesPerColumn();
  this->Entries = entries.sum();
  this->Operations = entries.square().sum();
}

double FactorWork::OfFactor() const
{
  return PerOperation * this->Operations + PerFactorEntry * this->Entries;
}

double FactorWork::OfSolve() const
{
  return PerSolvedEntry * this->Entries;
}

WorkLimit::WorkLimit(const SparseMatrix& matrix, int solves, double perRow)
  : Matrix(matrix)
  , Solves(solves)
  , PerRow(perRow)
{
}

bool WorkLimit::Allows(double spent, double remaining) const
{
  if (spent <= Unnoticed + UnnoticedPerRow * static_cast<double>(this->Matrix.rows()))
  {
    return true;
  }
  const double limit = this->Get();
  return spent <= limit && (spent <= Trial * limit || spent + remaining <= MostForeseen * limit);
}

double WorkLimit::Get() const
{
  if (this->Limit == 0.0)
  {
    const FactorWork work(this->Matrix);
    this->Limit = work.OfFactor() + this->Solves * (work.OfSolve() + this->PerRow * work.Rows);
  }
  return this->Limit;
}

double RemainingWork(double spent, double before, double now, double wanted)
{
  if (now <= wanted)
  {
    return 0.0;
  }
  return now < before ? spent * std::log(now / wanted) / std::log(before / now)
                      : std::numeric_limits<double>::infinity();
}
}
