// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Prolongator.h"

#include "Support/Threads.h"

#include <algorithm>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// The rows are transposed in this many parts at once.
constexpr Index AdjointParts = 8;
}

template <int B>
void Prolongator::Prolong(const float* y, float* x) const
{
  ParallelFor(this->FineRows(), PieceRows,
    [y, x, first = this->Begin.data(), columns = this->Column.data(), values = this->Value.data()](
      Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> sum;
        AddFewProducts(values, columns, first[v], first[v + 1], y, sum);
        sum.Store(x, v);
      }
    });
}

template <int B>
void Prolongator::AddTo(float* x, const float* y) const
{
  ParallelFor(this->FineRows(), PieceRows,
    [y, x, first = this->Begin.data(), columns = this->Column.data(), values = this->Value.data()](
      Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> sum(x, v);
        AddFewProducts(values, columns, first[v], first[v + 1], y, sum);
        sum.Store(x, v);
      }
    });
}

template <int B>
void Prolongator::Restrict(const float* x, float* y) const
{
  ParallelFor(this->CoarseRows(), PieceRows / 4,
    [y, x, first = this->AdjointBegin.data(), columns = this->AdjointColumn.data(),
      values = this->AdjointValue.data()](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> sum;
        AddManyProducts(values, columns, first[v], first[v + 1], x, sum);
        sum.Store(y, v);
      }
    });
}

void Prolongator::AddAdjoint(Index coarse)
{
  // The rows are cut into a few parts, which run at once. Each counts its entries in each column;
  // these counts, added up, say where its entries go.
  const Index rows = this->FineRows();
  const Index partRows = std::max(PieceRows, rows / AdjointParts + 1);
  std::vector<std::vector<Index>> at(NumberOfPieces(rows, partRows));
  ParallelFor(rows, partRows,
    [&](Index begin, Index end)
    {
      std::vector<Index>& counts = at[begin / partRows];
      counts.assign(coarse, 0);
      for (Index k = this->Begin[begin]; k < this->Begin[end]; ++k)
      {
        ++counts[this->Column[k]];
      }
    });
  this->AdjointBegin.resize(coarse + 1);
  Index place = 0;
  for (Index column = 0; column < coarse; ++column)
  {
    this->AdjointBegin[column] = place;
    for (std::vector<Index>& counts : at)
    {
      const Index count = counts[column];
      counts[column] = place;
      place += count;
    }
  }
  this->AdjointBegin[coarse] = place;
  ResizePadded(this->AdjointColumn, place);
  ResizePadded(this->AdjointValue, place);
  ParallelFor(rows, partRows,
    [&](Index begin, Index end)
    {
      std::vector<Index>& places = at[begin / partRows];
      for (Index row = begin; row < end; ++row)
      {
        for (Index k = this->Begin[row]; k < this->Begin[row + 1]; ++k)
        {
          const Index to = places[this->Column[k]]++;
          this->AdjointColumn[to] = row;
          this->AdjointValue[to] = std::conj(this->Value[k]);
        }
      }
    });
}

template void Prolongator::Prolong<1>(const float*, float*) const;
template void Prolongator::Prolong<4>(const float*, float*) const;
template void Prolongator::AddTo<1>(float*, const float*) const;
template void Prolongator::AddTo<4>(float*, const float*) const;
template void Prolongator::Restrict<1>(const float*, float*) const;
template void Prolongator::Restrict<4>(const float*, float*) const;
}
