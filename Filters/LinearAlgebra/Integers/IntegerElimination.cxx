// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/IntegerElimination.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
void Simplify(IntegerSum& sum)
{
  std::sort(sum.begin(), sum.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i < sum.size();)
  {
    std::pair<Index, std::int64_t> term{ sum[i].first, 0 };
    for (; i < sum.size() && sum[i].first == term.first; ++i)
    {
      term.second += sum[i].second;
    }
    if (term.second != 0)
    {
      sum[count++] = term;
    }
  }
  sum.resize(count);
}

/// By the greatest common divisor of the coefficients.
void Divide(IntegerSum& sum)
{
  std::int64_t divisor = 0;
  for (const auto& term : sum)
  {
    divisor = std::gcd(divisor, term.second);
  }
  for (auto& term : sum)
  {
    term.second /= divisor;
  }
}
}

IntegerElimination::IntegerElimination(std::vector<char> isInteger)
  : Integers(std::move(isInteger))
  , Dependent(this->Integers.size(), None)
{
}

Index IntegerElimination::AddFreeInteger()
{
  this->Integers.push_back(2);
  this->Dependent.push_back(None);
  return this->GetNumberOfVariables() - 1;
}

const IntegerSum& IntegerElimination::Resolve(Index variable)
{
  if (this->IsFree(variable))
  {
    this->Own = { { variable, 1 } };
    return this->Own;
  }
  const Index which = this->Dependent[variable];
  const bool isResolved = std::all_of(this->Sums[which].begin(), this->Sums[which].end(),
    [&](const std::pair<Index, std::int64_t>& term) { return this->IsFree(term.first); });
  if (!isResolved)
  {
    // Variables eliminated later are sums of free ones and of some eliminated later still.
    const IntegerSum sum = this->Sums[which];
    this->Sums[which] = this->Resolve(sum);
  }
  return this->Sums[which];
}

IntegerSum IntegerElimination::Resolve(const IntegerSum& sum)
{
  IntegerSum resolved;
  for (const auto& [variable, factor] : sum)
  {
    if (this->IsFree(variable))
    {
      resolved.emplace_back(variable, factor);
      continue;
    }
    for (const auto& [free, coefficient] : IntegerSum(this->Resolve(variable)))
    {
      resolved.emplace_back(free, coefficient * factor);
    }
  }
  Simplify(resolved);
  return resolved;
}

void IntegerElimination::MakeDependent(Index variable, IntegerSum sum)
{
  this->Dependent[variable] = static_cast<Index>(this->Sums.size());
  this->Sums.push_back(std::move(sum));
}

void IntegerElimination::SolveFor(std::size_t pivot, IntegerSum sum)
{
  const auto [variable, factor] = sum[pivot];
  sum.erase(sum.begin() + static_cast<std::ptrdiff_t>(pivot));
  for (auto& term : sum)
  {
    term.second *= -factor;
  }
  this->MakeDependent(variable, std::move(sum));
}

void IntegerElimination::RequireLocally(IntegerSum sum, Index own, Index other)
{
  sum = this->Resolve(sum);
  Divide(sum);
  const auto placeOf = [&](Index variable)
  {
    return static_cast<std::size_t>(std::find_if(sum.begin(), sum.end(),
                                      [&](const auto& term) { return term.first == variable; }) -
      sum.begin());
  };
  const std::size_t at = placeOf(own);
  if (at == sum.size())
  {
    this->Require(std::move(sum));
    return;
  }
  const std::int64_t p = sum[at].second;
  if (std::abs(p) != 1)
  {
    const auto isUnit = [&](std::size_t k)
    { return k < sum.size() && this->IsInteger(sum[k].first) && std::abs(sum[k].second) == 1; };
    std::size_t unit = placeOf(other);
    for (std::size_t k = 0; !isUnit(unit) && k < sum.size(); ++k)
    {
      unit = k;
    }
    if (!isUnit(unit))
    {
      this->Require(std::move(sum));
      return;
    }
    // With all terms that p does not divide, but y, as r: let y = p y' - r, up to signs. That makes
    // p divide everything.
    IntegerSum substitute = { { this->GetNumberOfVariables(), p } };
    this->Integers.push_back(1);
    this->Dependent.push_back(None);
    for (std::size_t k = 0; k < sum.size(); ++k)
    {
      const std::int64_t rest = sum[k].second % p;
      if (k != unit && rest != 0)
      {
        substitute.emplace_back(sum[k].first, -sum[unit].second * rest);
      }
    }
    Simplify(substitute);
    this->MakeDependent(sum[unit].first, std::move(substitute));
    sum = this->Resolve(sum);
    Divide(sum);
  }
  this->SolveFor(placeOf(own), std::move(sum));
}

void IntegerElimination::Require(IntegerSum sum)
{
  sum = this->Resolve(sum);
  while (!sum.empty())
  {
    Divide(sum);
    std::size_t pivot = sum.size();
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      // The last one of the least rank: real variables go before integers.
      const bool isUnit = std::abs(sum[i].second) == 1;
      if (isUnit &&
        (pivot == sum.size() || this->Integers[sum[i].first] <= this->Integers[sum[pivot].first]))
      {
        pivot = i;
      }
    }
    if (pivot < sum.size())
    {
      this->SolveFor(pivot, std::move(sum));
      return;
    }
    // A step of Euclid: with the least coefficient p of x, and another one q = s p + r of y, let
    // x = x' - s y. That leaves r for y.
    const auto least = std::min_element(sum.begin(), sum.end(),
      [](const auto& a, const auto& b) { return std::abs(a.second) < std::abs(b.second); });
    const auto [x, p] = *least;
    IntegerSum substitute;
    const Index fresh = this->GetNumberOfVariables();
    substitute.emplace_back(fresh, 1);
    bool isInteger = this->IsInteger(x);
    for (const auto& [y, q] : sum)
    {
      if (y != x && q / p != 0)
      {
        substitute.emplace_back(y, -(q / p));
        isInteger = isInteger && this->IsInteger(y);
      }
    }
    this->Integers.push_back(isInteger ? 1 : 0);
    this->Dependent.push_back(None);
    Simplify(substitute);
    this->MakeDependent(x, std::move(substitute));
    sum = this->Resolve(sum);
  }
}
}
