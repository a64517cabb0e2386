// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SchurSystem.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
SchurSystem::SchurSystem(Matrix lower, Index reals)
  : Size(static_cast<Index>(lower.cols()))
  , Reals(reals)
  , Lower(std::move(lower))
{
  this->Definite = this->Size == 0 || this->Factor.Compute(this->Lower, this->Size - this->Reals);
  if (this->Definite)
  {
    this->Trailing = this->Factor.TrailingFactor();
  }
}

void SchurSystem::Shrink(std::size_t mostValues)
{
  if (this->Factor.GetNumberOfValues() > mostValues)
  {
    this->IsReleased = true;
    this->Factor.ReleaseValues();
    this->Trailing.resize(0, 0);
  }
  else
  {
    Matrix().swap(this->Lower);
  }
}

void SchurSystem::Restore()
{
  if (this->IsReleased && this->Definite)
  {
    this->Factor.FactorAgain(this->Lower);
    this->Trailing = this->Factor.TrailingFactor();
  }
  this->IsReleased = false;
}

Eigen::VectorXd SchurSystem::Solve(const Eigen::VectorXd& rightHandSide) const
{
  return this->Size == 0 ? rightHandSide : this->Factor.Solve(rightHandSide);
}

Eigen::VectorXd SchurSystem::SolveWith(
  const Eigen::VectorXd& relaxed, const Eigen::VectorXd& integers) const
{
  const Index count = this->Size - this->Reals;
  Eigen::VectorXd solution = relaxed;
  if (this->Size > 0)
  {
    solution += this->Factor.Continued(integers - relaxed.tail(count));
  }
  solution.tail(count) = integers;
  return solution;
}

Eigen::VectorXd SolveInRounds(
  const SchurSystem::Matrix& lower, const Eigen::VectorXd& rightHandSide, Index reals)
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
    std::vector<Eigen::Triplet<double, std::int32_t>> left;
    for (Index j = 0; j < size; ++j)
    {
      for (SchurSystem::Matrix::InnerIterator entry(lower, j); entry; ++entry)
      {
        const Index i = entry.row();
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
    }
    SchurSystem::Matrix rest(count, count);
    rest.setFromTriplets(left.begin(), left.end());
    std::vector<Eigen::Triplet<double, std::int32_t>>().swap(left);
    const SchurSystem system(std::move(rest), count);
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
