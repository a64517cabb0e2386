// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeMap/LatticeSystem.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields::Internal
{
LatticeSystem::LatticeSystem(std::vector<Entry>& entries, Index size, Index reals)
  : Size(size)
  , Reals(reals)
  , Place(size)
{
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<Entry>().swap(entries);
  std::iota(this->Place.begin(), this->Place.end(), 0);
  if (reals > 0)
  {
    const Matrix block = matrix.topLeftCorner(reals, reals);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> order;
    Eigen::AMDOrdering<std::int32_t>()(block.selfadjointView<Eigen::Lower>(), order);
    for (Index i = 0; i < reals; ++i)
    {
      this->Place[order.indices()[i]] = i;
    }
  }
  std::vector<Entry> placed;
  placed.reserve(matrix.nonZeros());
  for (Index column = 0; column < size; ++column)
  {
    for (Matrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      const Index i = this->Place[entry.row()];
      const Index j = this->Place[column];
      placed.emplace_back(std::max(i, j), std::min(i, j), entry.value());
    }
  }
  matrix.setFromTriplets(placed.begin(), placed.end());
  this->Factor.compute(matrix);
  this->Definite = this->Factor.info() == Eigen::Success;
}

Eigen::VectorXd LatticeSystem::Solve(const Eigen::VectorXd& rightHandSide) const
{
  Eigen::VectorXd placed(this->Size);
  for (Index i = 0; i < this->Size; ++i)
  {
    placed[this->Place[i]] = rightHandSide[i];
  }
  const Eigen::VectorXd x = this->Factor.solve(placed);
  Eigen::VectorXd solution(this->Size);
  for (Index i = 0; i < this->Size; ++i)
  {
    solution[i] = x[this->Place[i]];
  }
  return solution;
}

Eigen::VectorXd LatticeSystem::SolveWith(
  const Eigen::VectorXd& rightHandSide, const Eigen::VectorXd& integers) const
{
  Eigen::VectorXd y(this->Size);
  for (Index i = 0; i < this->Size; ++i)
  {
    y[this->Place[i]] = rightHandSide[i];
  }
  // L^T x = y from the last row on, the rows of the integers being what they are.
  const Matrix& lower = this->Factor.matrixL().nestedExpression();
  lower.triangularView<Eigen::Lower>().solveInPlace(y);
  y.tail(this->Size - this->Reals) = integers;
  for (Index column = this->Reals - 1; column >= 0; --column)
  {
    double sum = y[column];
    double diagonal = 1.0;
    for (Matrix::InnerIterator entry(lower, column); entry; ++entry)
    {
      if (entry.row() == column)
      {
        diagonal = entry.value();
      }
      else if (entry.row() > column)
      {
        sum -= entry.value() * y[entry.row()];
      }
    }
    y[column] = sum / diagonal;
  }
  Eigen::VectorXd solution(this->Size);
  for (Index i = 0; i < this->Size; ++i)
  {
    solution[i] = y[this->Place[i]];
  }
  return solution;
}

Eigen::MatrixXd LatticeSystem::TrailingFactor() const
{
  const Index count = this->Size - this->Reals;
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(count, count);
  const Matrix& lower = this->Factor.matrixL().nestedExpression();
  for (Index column = this->Reals; column < this->Size; ++column)
  {
    for (Matrix::InnerIterator entry(lower, column); entry; ++entry)
    {
      factor(entry.row() - this->Reals, column - this->Reals) = entry.value();
    }
  }
  return factor;
}

Eigen::VectorXd SolveInRounds(const std::vector<LatticeSystem::Entry>& entries,
  const Eigen::VectorXd& rightHandSide, Index reals)
{
  constexpr int rounds = 4;
  const auto size = static_cast<Index>(rightHandSide.size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
  std::vector<char> isFixed(size, 0);
  for (int round = 0; round <= rounds; ++round)
  {
    std::vector<Index> place(size, None);
    Index count = 0;
    for (Index i = 0; i < size; ++i)
    {
      place[i] = isFixed[i] == 0 ? count++ : None;
    }
    Eigen::VectorXd side(count);
    for (Index i = 0; i < size; ++i)
    {
      if (isFixed[i] == 0)
      {
        side[place[i]] = rightHandSide[i];
      }
    }
    std::vector<LatticeSystem::Entry> left;
    for (const LatticeSystem::Entry& entry : entries)
    {
      const Index i = entry.row();
      const Index j = entry.col();
      if (isFixed[i] == 0 && isFixed[j] == 0)
      {
        left.emplace_back(place[i], place[j], entry.value());
      }
      else if (isFixed[i] == 0)
      {
        side[place[i]] -= entry.value() * x[j];
      }
      else if (isFixed[j] == 0)
      {
        side[place[j]] -= entry.value() * x[i];
      }
    }
    const LatticeSystem system(left, count, count);
    if (!system.IsDefinite())
    {
      return {};
    }
    const Eigen::VectorXd solution = system.Solve(side);
    std::vector<std::pair<double, Index>> order;
    for (Index i = 0; i < size; ++i)
    {
      if (isFixed[i] == 0)
      {
        x[i] = solution[place[i]];
        if (i >= reals)
        {
          order.emplace_back(std::abs(x[i] - std::nearbyint(x[i])), i);
        }
      }
    }
    std::sort(order.begin(), order.end());
    // All that are left in the last round but one.
    const std::size_t part = (order.size() + rounds - 1 - round) / std::max(1, rounds - round);
    for (std::size_t k = 0; k < std::min(part, order.size()); ++k)
    {
      const Index i = order[k].second;
      x[i] = std::nearbyint(x[i]);
      isFixed[i] = 1;
    }
  }
  return x;
}
}
