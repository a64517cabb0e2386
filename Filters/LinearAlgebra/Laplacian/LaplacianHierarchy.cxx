// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Laplacian/LaplacianHierarchy.h"

#include "Matrices/RowSum.h"
#include "Matrices/StrongAggregates.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceRows = SweptLaplacian::PieceRows;
/// An edge is strong above this part of the geometric mean of the two diagonal entries. From level
/// to level the part is multiplied by StrongPartDecay.
constexpr float StrongPart = 0.08F;
constexpr float StrongPartDecay = 0.7F;
/// Weak edges that are lumped into the diagonal leave at least this part of it.
constexpr float LeastFilteredDiagonal = 0.3F;
/// Damping of the prolongator's smoothing, over the largest eigenvalue.
constexpr float Damping = 4.0F / 3.0F;
/// Coarsening ends where a level would have more than this part of the rows of the finer one.
constexpr double SlowestCoarsening = 0.7;

/// How strongly rows are joined.
struct Strengths
{
  /// Of each entry its weight, or 0 where it is weak.
  LargeArray<float> Weight;
  /// With the weak edges lumped into it.
  LargeArray<float> Diagonal;
};

Strengths FindStrengths(const GraphLaplacian& matrix, int level)
{
  const float part = StrongPart * std::pow(StrongPartDecay, static_cast<float>(level));
  Strengths strengths{ LargeArray<float>(matrix.Entries()), LargeArray<float>(matrix.Rows()) };
  ParallelFor(matrix.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        float lumped = matrix.Diagonal[i];
        for (Index k = matrix.Begin[i]; k < matrix.Begin[i + 1]; ++k)
        {
          const float weight = matrix.Weight[k];
          const float bound = part * part * matrix.Diagonal[i] * matrix.Diagonal[matrix.Column[k]];
          const bool isStrong = weight > 0.0F && weight * weight > bound;
          strengths.Weight[k] = isStrong ? weight : 0.0F;
          lumped -= isStrong ? 0.0F : weight;
        }
        strengths.Diagonal[i] = std::max(lumped, LeastFilteredDiagonal * matrix.Diagonal[i]);
      }
    });
  return strengths;
}

/// The aggregates' constants after one damped Jacobi step on the strong edges.
NumberProlongator MakeProlongator(
  const GraphLaplacian& matrix, const Strengths& strengths, const LargeArray<Index>& number)
{
  const SummedRows<float> rows(matrix.Rows(), false,
    [&](Index i, RowSum<float>& sum)
    {
      float radius = strengths.Diagonal[i];
      for (Index k = matrix.Begin[i]; k < matrix.Begin[i + 1]; ++k)
      {
        radius += strengths.Weight[k];
      }
      const float step = radius > 0.0F ? Damping / radius : 0.0F;
      sum[number[i]] += 1.0F - step * strengths.Diagonal[i];
      for (Index k = matrix.Begin[i]; k < matrix.Begin[i + 1]; ++k)
      {
        if (strengths.Weight[k] > 0.0F)
        {
          sum[number[matrix.Column[k]]] += step * strengths.Weight[k];
        }
      }
    });
  constexpr Index width = SweptLaplacian::Width;
  NumberProlongator p;
  p.Begin.resize(rows.Size.size() + 1);
  p.End.resize(rows.Size.size());
  p.Begin[0] = 0;
  for (std::size_t i = 0; i < rows.Size.size(); ++i)
  {
    p.End[i] = p.Begin[i] + rows.Size[i];
    p.Begin[i + 1] = p.Begin[i] + (rows.Size[i] + width - 1) / width * width;
  }
  p.Column.resize(p.Begin.back());
  p.Value.resize(p.Begin.back());
  rows.ForEach(
    [&](Index row, Index k, const std::pair<Index, float>& entry)
    {
      const Index last = k + 1 == rows.Size[row] ? p.Begin[row + 1] : p.Begin[row] + k + 1;
      std::fill(p.Column.begin() + p.Begin[row] + k, p.Column.begin() + last, entry.first);
      std::fill(p.Value.begin() + p.Begin[row] + k, p.Value.begin() + last, 0.0F);
      p.Value[p.Begin[row] + k] = entry.second;
    });
  return p;
}

/// P^T L P
GraphLaplacian Coarsen(const GraphLaplacian& matrix, const NumberProlongator& p)
{
  // L P, whose rows need no order, and whose columns may come several times.
  const SummedRows<float> products(matrix.Rows(), false,
    [&](Index i, RowSum<float>& sum)
    {
      for (Index e = p.Begin[i]; e < p.End[i]; ++e)
      {
        sum[p.Column[e]] += matrix.Diagonal[i] * p.Value[e];
      }
      for (Index k = matrix.Begin[i]; k < matrix.Begin[i + 1]; ++k)
      {
        const Index j = matrix.Column[k];
        for (Index e = p.Begin[j]; e < p.End[j]; ++e)
        {
          sum[p.Column[e]] -= matrix.Weight[k] * p.Value[e];
        }
      }
    });
  LargeArray<Index> within(matrix.Rows());
  for (const auto& piece : products.Pieces)
  {
    const auto first = static_cast<Index>(&piece - products.Pieces.data()) * products.PieceRows;
    Index at = 0;
    for (Index i = first; i < std::min(first + products.PieceRows, matrix.Rows()); ++i)
    {
      within[i] = at;
      at += products.Size[i];
    }
  }
  const SummedRows<float> rows(p.CoarseRows(), true,
    [&](Index row, RowSum<float>& sum)
    {
      for (Index e = p.AdjointBegin[row]; e < p.AdjointBegin[row + 1]; ++e)
      {
        const Index i = p.AdjointColumn[e];
        const auto* product = products.Pieces[i / products.PieceRows].data() + within[i];
        for (Index k = 0; k < products.Size[i]; ++k)
        {
          sum[product[k].first] += p.AdjointValue[e] * product[k].second;
        }
      }
    });
  const LargeArray<Index> rowBegin = rows.Begin();
  GraphLaplacian coarse;
  const Index n = p.CoarseRows();
  coarse.Begin.resize(static_cast<std::size_t>(n) + 1);
  coarse.Diagonal.resize(n);
  // Each row has its diagonal entry, which is left out.
  for (Index v = 0; v <= n; ++v)
  {
    coarse.Begin[v] = rowBegin[v] - v;
  }
  coarse.Column.resize(coarse.Entries());
  coarse.Weight.resize(coarse.Entries());
  rows.ForEach(
    [&](Index row, Index k, const std::pair<Index, float>& entry)
    {
      if (entry.first == row)
      {
        coarse.Diagonal[row] = entry.second;
        return;
      }
      const Index at = coarse.Begin[row] + k - (entry.first > row ? 1 : 0);
      coarse.Column[at] = entry.first;
      coarse.Weight[at] = -entry.second;
    });
  return coarse;
}
}

void NumberProlongator::AddAdjoint(Index coarse)
{
  this->AdjointBegin.assign(static_cast<std::size_t>(coarse) + 1, 0);
  for (Index row = 0; row < this->FineRows(); ++row)
  {
    for (Index k = this->Begin[row]; k < this->End[row]; ++k)
    {
      ++this->AdjointBegin[this->Column[k]];
    }
  }
  Index end = 0;
  for (Index& begin : this->AdjointBegin)
  {
    end += begin;
    begin = end;
  }
  this->AdjointColumn.resize(end);
  this->AdjointValue.resize(end);
  for (Index row = this->FineRows(); row-- > 0;)
  {
    for (Index k = this->Begin[row]; k < this->End[row]; ++k)
    {
      const Index to = --this->AdjointBegin[this->Column[k]];
      this->AdjointColumn[to] = row;
      this->AdjointValue[to] = this->Value[k];
    }
  }
}

void NumberProlongator::AddTo(float* x, const float* y) const
{
  ParallelFor(this->FineRows(), PieceRows,
    [x, y, begins = this->Begin.data(), columns = this->Column.data(), values = this->Value.data()](
      Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        x[v] += SumOfProducts(values, columns, begins[v], begins[v + 1], y);
      }
    });
}

void NumberProlongator::Restrict(const float* x, float* y) const
{
  ParallelFor(this->CoarseRows(), PieceRows / 4,
    [x, y, begins = this->AdjointBegin.data(), columns = this->AdjointColumn.data(),
      values = this->AdjointValue.data()](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        float sum = 0.0F;
        for (Index k = begins[v]; k < begins[v + 1]; ++k)
        {
          sum += values[k] * x[columns[k]];
        }
        y[v] = sum;
      }
    });
}

LaplacianHierarchy::LaplacianHierarchy(GraphLaplacian&& finest, const Eigen::VectorXd& mass)
{
  GraphLaplacian matrix = std::move(finest);
  LargeArray<float> masses(static_cast<std::size_t>(mass.size()));
  std::transform(mass.begin(), mass.end(), masses.begin(),
    [](double value) { return static_cast<float>(value); });
  for (;;)
  {
    this->Levels.push_back({ SweptLaplacian(matrix), std::move(masses), {} });
    Level& level = this->Levels.back();
    if (matrix.Rows() <= CoarsestRows)
    {
      return;
    }
    const Strengths strengths = FindStrengths(matrix, static_cast<int>(this->Levels.size()) - 1);
    LargeArray<Index> number;
    const Index count = AggregateStrongly(
      { matrix.Rows(), matrix.Begin.data(), matrix.Column.data(), strengths.Weight.data() }, number,
      [](Index) {}, [](Index, Index) {}, [](Index) { return true; });
    if (count > SlowestCoarsening * matrix.Rows())
    {
      return;
    }
    level.FromCoarser = MakeProlongator(matrix, strengths, number);
    level.FromCoarser.AddAdjoint(count);
    matrix = Coarsen(matrix, level.FromCoarser);
    masses = LargeArray<float>(count);
    level.FromCoarser.Restrict(level.Mass.data(), masses.data());
  }
}
}
