// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SchurSystem.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
SchurSystem::SchurSystem(std::vector<Entry>& entries, Index size, Index reals)
  : Size(size)
  , Reals(reals)
{
  this->Lower.resize(size, size);
  this->Lower.setFromTriplets(entries.begin(), entries.end());
  std::vector<Entry>().swap(entries);
  this->Definite = size == 0 || this->Factor.Compute(this->Lower, size - reals);
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
  const std::vector<SchurSystem::Entry>& entries, const Eigen::VectorXd& rightHandSide, Index reals)
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
    std::vector<SchurSystem::Entry> left;
    for (const SchurSystem::Entry& entry : entries)
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
    const SchurSystem system(left, count, count);
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
