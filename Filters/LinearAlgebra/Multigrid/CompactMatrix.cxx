// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/CompactMatrix.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A row is local where its couplings add up to more than this times the diagonal.
constexpr float MostCouplings = 1.2f;
/// No more than this part of all rows are local, besides the rows that they are coupled with.
constexpr double MostLocalRows = 0.01;
}

CompactMatrix::CompactMatrix(const SparseMatrix& matrix)
{
  const auto rows = static_cast<Index>(matrix.cols());
  const auto entries = static_cast<Index>(matrix.nonZeros()) - rows;
  this->Begin.resize(rows + 1);
  this->Diagonal.resize(rows);
  ResizePadded(this->Column, entries);
  ResizePadded(this->Value, entries);
  const Index* outer = matrix.outerIndexPtr();
  const Index* inner = matrix.innerIndexPtr();
  const Complex* values = matrix.valuePtr();
  this->Begin[rows] = entries;
  ParallelFor(rows, PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        // Every row has its diagonal entry, which is left out.
        Index at = outer[v] - v;
        this->Begin[v] = at;
        for (Index k = outer[v]; k < outer[v + 1]; ++k)
        {
          if (inner[k] == v)
          {
            this->Diagonal[v] = static_cast<float>(values[k].real());
            continue;
          }
          this->Column[at] = inner[k];
          // A column of a Hermitian matrix is the conjugate of the row.
          this->Value[at++] = CompactComplex(std::conj(values[k]));
        }
      }
    });
  this->OrderByBlocks();
}

void CompactMatrix::OrderByBlocks(LargeArray<CompactComplex>* other)
{
  const Index rows = this->Rows();
  this->Inside.resize(rows);
  std::vector<std::vector<Index>> boundary(NumberOfPieces(rows, BlockRows));
  ParallelFor(rows, BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Index first = this->Begin[v];
        const Index last = this->Begin[v + 1];
        Index in = first;
        while (in < last && this->Column[in] < begin)
        {
          ++in;
        }
        Index out = in;
        while (out < last && this->Column[out] < end)
        {
          ++out;
        }
        this->Inside[v] = first + (out - in);
        if (out - in == last - first)
        {
          continue;
        }
        boundary[begin / BlockRows].push_back(v);
        const auto moveLeft = [&](auto& values)
        { std::rotate(values.begin() + first, values.begin() + in, values.begin() + last); };
        moveLeft(this->Column);
        moveLeft(this->Value);
        if (other)
        {
          moveLeft(*other);
        }
      }
    });
  for (const std::vector<Index>& piece : boundary)
  {
    this->Boundary.insert(this->Boundary.end(), piece.begin(), piece.end());
  }
}

void CompactMatrix::PrepareSweeps()
{
  ResizePadded(this->ColumnInBlock, this->Entries());
  ParallelFor(this->Rows(), BlockRows,
    [&](Index begin, Index end)
    {
      for (Index k = this->Begin[begin]; k < this->Begin[end]; ++k)
      {
        const Index column = this->Column[k];
        this->ColumnInBlock[k] =
          static_cast<std::uint16_t>(begin <= column && column < end ? column - begin : 0);
      }
    });
  const auto count = static_cast<Index>(this->Boundary.size());
  this->OutsideBegin.resize(count + 1);
  this->OutsideBegin[0] = 0;
  for (Index j = 0; j < count; ++j)
  {
    const Index v = this->Boundary[j];
    this->OutsideBegin[j + 1] = this->OutsideBegin[j] + this->Begin[v + 1] - this->Inside[v];
  }
  this->OutsideColumn.resize(this->OutsideBegin[count]);
  this->OutsideValue.resize(this->OutsideBegin[count]);
  ParallelFor(count, PieceRows,
    [&](Index begin, Index end)
    {
      for (Index j = begin; j < end; ++j)
      {
        const Index first = this->Inside[this->Boundary[j]] - this->OutsideBegin[j];
        for (Index k = this->OutsideBegin[j]; k < this->OutsideBegin[j + 1]; ++k)
        {
          this->OutsideColumn[k] = this->BoundaryFrom(this->Column[first + k]);
          this->OutsideValue[k] = this->Value[first + k];
        }
      }
    });
}

void CompactMatrix::FindLocalRows()
{
  const Index rows = this->Rows();
  using Excess = std::pair<float, Index>;
  std::vector<std::vector<Excess>> found(NumberOfPieces(rows, PieceRows));
  ParallelFor(rows, PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        float sum = 0.0f;
        for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
        {
          sum += Modulus(this->Value[k]);
        }
        if (sum > MostCouplings * this->Diagonal[v])
        {
          found[begin / PieceRows].emplace_back(-sum / this->Diagonal[v], v);
        }
      }
    });
  std::vector<Excess> worst;
  for (const std::vector<Excess>& piece : found)
  {
    worst.insert(worst.end(), piece.begin(), piece.end());
  }
  std::sort(worst.begin(), worst.end());
  worst.resize(std::min(worst.size(), static_cast<std::size_t>(MostLocalRows * rows)));
  std::vector<Index> local;
  for (const auto& [excess, v] : worst)
  {
    local.push_back(v);
    local.insert(local.end(), this->Column.begin() + this->Begin[v],
      this->Column.begin() + this->Begin[v + 1]);
  }
  std::sort(local.begin(), local.end());
  local.erase(std::unique(local.begin(), local.end()), local.end());
  this->Local.clear();
  for (const Index v : local)
  {
    this->Local.push_back(
      { v, this->Inside[v] < this->Begin[v + 1] ? this->BoundaryFrom(v) : None });
  }
}

Index CompactMatrix::BoundaryFrom(Index row) const
{
  return static_cast<Index>(
    std::lower_bound(this->Boundary.begin(), this->Boundary.end(), row) - this->Boundary.begin());
}
}
