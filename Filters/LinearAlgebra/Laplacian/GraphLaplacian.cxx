// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Laplacian/GraphLaplacian.h"

#include "Matrices/RowSum.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <utility>

namespace DirectionFields::Internal
{
void GraphLaplacian::Merge()
{
  const SummedRows<float> rows(this->Rows(), true,
    [&](Index v, RowSum<float>& sum)
    {
      for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
      {
        sum[this->Column[k]] += this->Weight[k];
      }
    });
  this->Begin = rows.Begin();
  this->Column.resize(this->Entries());
  this->Weight.resize(this->Entries());
  rows.ForEach(
    [&](Index row, Index k, const std::pair<Index, float>& entry)
    {
      this->Column[this->Begin[row] + k] = entry.first;
      this->Weight[this->Begin[row] + k] = entry.second;
    });
}

namespace
{
constexpr Index Width = SweptLaplacian::Width;

Index Padded(Index count)
{
  return (count + Width - 1) / Width * Width;
}

/// The numbers of entries of a row in columns of its block before it, after it, and in other
/// blocks.
std::array<Index, 3> CountParts(const GraphLaplacian& matrix, Index v, Index begin, Index end)
{
  std::array<Index, 3> counts{};
  for (Index k = matrix.Begin[v]; k < matrix.Begin[v + 1]; ++k)
  {
    const Index column = matrix.Column[k];
    const Index isLower = begin <= column && column < v ? 1 : 0;
    const Index isUpper = v < column && column < end ? 1 : 0;
    counts[0] += isLower;
    counts[1] += isUpper;
    counts[2] += 1 - isLower - isUpper;
  }
  return counts;
}
}

SweptLaplacian::SweptLaplacian(const GraphLaplacian& matrix)
  : Begin(matrix.Begin.size())
  , Lower(matrix.Diagonal.size())
  , Inside(matrix.Diagonal.size())
  , Diagonal(matrix.Diagonal)
{
  this->Begin[0] = 0;
  ParallelFor(matrix.Rows(), BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const std::array<Index, 3> counts = CountParts(matrix, v, begin, end);
        this->Lower[v] = Padded(counts[0]);
        this->Inside[v] = Padded(counts[1]);
        this->Begin[v + 1] = this->Lower[v] + this->Inside[v] + Padded(counts[2]);
      }
    });
  for (Index v = 0; v < matrix.Rows(); ++v)
  {
    this->Lower[v] += this->Begin[v];
    this->Inside[v] += this->Lower[v];
    this->Begin[v + 1] += this->Begin[v];
  }
  this->Column.resize(this->Entries());
  this->Weight.resize(this->Entries());
  ParallelFor(matrix.Rows(), BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        std::fill(
          this->Column.begin() + this->Begin[v], this->Column.begin() + this->Begin[v + 1], v);
        std::fill(
          this->Weight.begin() + this->Begin[v], this->Weight.begin() + this->Begin[v + 1], 0.0F);
        std::array<Index, 3> at = { this->Begin[v], this->Lower[v], this->Inside[v] };
        for (Index k = matrix.Begin[v]; k < matrix.Begin[v + 1]; ++k)
        {
          const Index column = matrix.Column[k];
          const bool isInside = begin <= column && column < end;
          const Index to = at[isInside ? (column < v ? 0 : 1) : 2]++;
          this->Column[to] = column;
          this->Weight[to] = matrix.Weight[k];
        }
      }
    });
}

double SweptLaplacian::Multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const
{
  y.resize(x.size());
  return ParallelSum<double>(this->Rows(), PieceRows, 0.0,
    [begins = this->Begin.data(), columns = this->Column.data(), weights = this->Weight.data(),
      from = x.data(), to = y.data()](Index begin, Index end)
    {
      double product = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        const double own = from[v];
        double even = 0.0;
        double odd = 0.0;
        for (Index k = begins[v]; k < begins[v + 1]; k += 2)
        {
          even += static_cast<double>(weights[k]) * (own - from[columns[k]]);
          odd += static_cast<double>(weights[k + 1]) * (own - from[columns[k + 1]]);
        }
        to[v] = even + odd;
        product += own * to[v];
      }
      return product;
    });
}
}
