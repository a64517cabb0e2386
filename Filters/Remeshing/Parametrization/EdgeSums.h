// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EdgeSums_h
#define DirectionFields_EdgeSums_h

#include "SparseCholesky/SchurSystem.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// The edges of a map: each of the two coordinates of an edge is a sum of variables, and its square
/// has a weight. Sums may have many terms, where the jump that an edge crosses depends on many
/// integers: they are stored once, and pairs of terms not at all.
class EdgeSums
{
public:
  struct Term
  {
    Index Variable;
    double Factor;
  };

  /// Makes room for the edges of a map; most of them lead from one vertex to another.
  void Reserve(std::size_t edges);
  void Append(double weight, const std::array<std::vector<Term>, 2>& coordinates);
  void ShrinkToFit();

  std::size_t GetNumberOfTerms() const { return this->Terms.size(); }
  double GetWeight(std::size_t edge) const { return this->Weights[edge]; }

  /// Calls visit(variable, factor) for the terms of a coordinate.
  template <typename Visit>
  void ForTerms(std::size_t edge, int coordinate, const Visit& visit) const
  {
    const std::size_t sum = 2 * edge + static_cast<std::size_t>(coordinate);
    for (std::size_t k = this->Begin(sum); k < this->Ends[sum]; ++k)
    {
      visit(this->Terms[k], this->Factors[k]);
    }
  }

  /// The lower triangle of the matrix K for which x^T K x is the sum over the edges of
  /// weight (a^2 + b^2 + 2 mixed a b), a and b being their coordinates.
  /// @param variables rows of the matrix
  SchurSystem::Matrix Squares(Index variables, double mixed) const;

private:
  class ByVariable;
  std::size_t Begin(std::size_t sum) const { return sum == 0 ? 0 : this->Ends[sum - 1]; }

  std::vector<double> Weights;
  /// Of the first coordinate of the first edge, the second one, and so on.
  std::vector<Index> Terms;
  std::vector<double> Factors;
  /// Where each coordinate's sum ends.
  std::vector<std::size_t> Ends;
};
}

#endif
