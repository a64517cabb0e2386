// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/EdgeSums.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
void EdgeSums::Reserve(std::size_t edges)
{
  this->Weights.reserve(edges);
  this->Ends.reserve(2 * edges);
  this->Terms.reserve(4 * edges);
  this->Factors.reserve(4 * edges);
}

void EdgeSums::Append(double weight, const std::array<std::vector<Term>, 2>& coordinates)
{
  this->Weights.push_back(weight);
  for (const std::vector<Term>& terms : coordinates)
  {
    for (const Term& term : terms)
    {
      this->Terms.push_back(term.Variable);
      this->Factors.push_back(term.Factor);
    }
    this->Ends.push_back(this->Terms.size());
  }
}

void EdgeSums::ShrinkToFit()
{
  this->Weights.shrink_to_fit();
  this->Ends.shrink_to_fit();
  this->Terms.shrink_to_fit();
  this->Factors.shrink_to_fit();
}

/// The sums that each variable is in, with its factor there.
class EdgeSums::ByVariable
{
public:
  ByVariable(const EdgeSums& sums, Index variables)
    : Ends(variables, 0)
    , Sums(sums.Terms.size())
    , Factors(sums.Terms.size())
  {
    for (const Index variable : sums.Terms)
    {
      ++this->Ends[variable];
    }
    std::size_t count = 0;
    for (std::size_t& end : this->Ends)
    {
      count += std::exchange(end, count);
    }
    for (std::size_t sum = 0; sum < sums.Ends.size(); ++sum)
    {
      for (std::size_t k = sums.Begin(sum); k < sums.Ends[sum]; ++k)
      {
        const std::size_t place = this->Ends[sums.Terms[k]]++;
        this->Sums[place] = sum;
        this->Factors[place] = sums.Factors[k];
      }
    }
  }

  template <typename Visit>
  void ForSums(Index variable, const Visit& visit) const
  {
    for (std::size_t k = variable == 0 ? 0 : this->Ends[variable - 1]; k < this->Ends[variable];
         ++k)
    {
      visit(this->Sums[k], this->Factors[k]);
    }
  }

private:
  std::vector<std::size_t> Ends;
  std::vector<std::size_t> Sums;
  std::vector<double> Factors;
};

SchurSystem::Matrix EdgeSums::Squares(Index variables, double mixed) const
{
  const ByVariable transposed(*this, variables);
  SchurSystem::Matrix matrix(variables, variables);
  std::vector<std::int32_t> rows;
  std::vector<double> values;
  std::vector<double> column(variables, 0.0);
  std::vector<Index> last(variables, None);
  for (Index v = 0; v < variables; ++v)
  {
    matrix.outerIndexPtr()[v] = static_cast<std::int32_t>(rows.size());
    const std::size_t first = rows.size();
    const auto add = [&](std::size_t sum, double factor)
    {
      // The terms are in ascending order.
      for (std::size_t k = this->Ends[sum]; k > this->Begin(sum) && this->Terms[k - 1] >= v; --k)
      {
        const Index row = this->Terms[k - 1];
        if (last[row] != v)
        {
          last[row] = v;
          column[row] = 0.0;
          rows.push_back(row);
        }
        column[row] += factor * this->Factors[k - 1];
      }
    };
    transposed.ForSums(v,
      [&](std::size_t sum, double factor)
      {
        const double weighted = this->Weights[sum / 2] * factor;
        add(sum, weighted);
        if (mixed != 0.0)
        {
          add(sum ^ 1u, mixed * weighted);
        }
      });
    std::sort(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end());
    for (std::size_t k = first; k < rows.size(); ++k)
    {
      values.push_back(column[rows[k]]);
    }
  }
  matrix.outerIndexPtr()[variables] = static_cast<std::int32_t>(rows.size());
  matrix.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(rows.begin(), rows.end(), matrix.innerIndexPtr());
  std::copy(values.begin(), values.end(), matrix.valuePtr());
  return matrix;
}
}
