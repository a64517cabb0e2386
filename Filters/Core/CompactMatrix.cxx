// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CompactMatrix.h"

#include "Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
CompactMatrix::CompactMatrix(const SparseMatrix& matrix)
{
  const auto rows = static_cast<Index>(matrix.cols());
  const auto entries = static_cast<std::size_t>(matrix.nonZeros()) - rows;
  this->Begin.resize(rows + 1);
  this->Upper.resize(rows);
  this->Diagonal.resize(rows);
  this->Column.resize(entries);
  this->Value.resize(entries);
  const Index* outer = matrix.outerIndexPtr();
  const Index* inner = matrix.innerIndexPtr();
  const Complex* values = matrix.valuePtr();
  this->Begin[rows] = static_cast<Index>(entries);
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
            this->Upper[v] = at;
            this->Diagonal[v] = static_cast<float>(values[k].real());
            continue;
          }
          this->Column[at] = inner[k];
          // A column of a Hermitian matrix is the conjugate of the row.
          this->Value[at++] = CompactComplex(std::conj(values[k]));
        }
      }
    });
}

SweepDiagonal::SweepDiagonal(const CompactMatrix& matrix, const std::vector<float>& m, float shift)
  : Inverse(matrix.Rows())
  , Extra(matrix.Rows())
{
  ParallelFor(matrix.Rows(), CompactMatrix::BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        float extra = 0.0f;
        for (Index k = matrix.Begin[v]; k < matrix.Begin[v + 1]; ++k)
        {
          if (matrix.Column[k] < begin || matrix.Column[k] >= end)
          {
            extra += Modulus(matrix.Value[k]);
          }
        }
        this->Extra[v] = extra;
        this->Inverse[v] = 1.0f / (matrix.Diagonal[v] + shift * m[v] + extra);
      }
    });
}

template <int B>
void SweepDown(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b, float* x,
  float* r)
{
  ParallelFor(matrix.Rows(), CompactMatrix::BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> sum;
        Index k = matrix.Begin[v];
        while (k < matrix.Upper[v] && matrix.Column[k] < begin)
        {
          ++k;
        }
        matrix.AddTimes<B>(k, matrix.Upper[v], x, sum);
        sum.AddReal(-1.0f, b, v);
        sum.Scale(-diagonal.Inverse[v]);
        sum.Store(x, v);
      }
    });
  // The sweep has solved for the diagonal and what is left of it within the block.
  ParallelFor(matrix.Rows(), CompactMatrix::BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> rest;
        for (Index k = matrix.Begin[v]; k < matrix.Upper[v] && matrix.Column[k] < begin; ++k)
        {
          rest.Add(matrix.Value[k], x, matrix.Column[k]);
        }
        matrix.AddTimes<B>(matrix.Upper[v], matrix.Begin[v + 1], x, rest);
        rest.AddReal(-diagonal.Extra[v], x, v);
        rest.Scale(-1.0f);
        rest.Store(r, v);
      }
    });
}

template <int B>
void SweepUp(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* x, float* y)
{
  ParallelFor(matrix.Rows(), CompactMatrix::BlockRows,
    [&](Index begin, Index end)
    {
      for (Index v = end; v-- > begin;)
      {
        CompactValues<B> sum;
        // What is old does not wait for the row below.
        matrix.AddTimes<B>(matrix.Begin[v], matrix.Upper[v], x, sum);
        Index outside = matrix.Begin[v + 1];
        for (; outside > matrix.Upper[v] && matrix.Column[outside - 1] >= end; --outside)
        {
          sum.Add(matrix.Value[outside - 1], x, matrix.Column[outside - 1]);
        }
        matrix.AddTimes<B>(matrix.Upper[v], outside, y, sum);
        sum.AddReal(-diagonal.Extra[v], x, v);
        sum.AddReal(-1.0f, b, v);
        sum.Scale(-diagonal.Inverse[v]);
        sum.Store(y, v);
      }
    });
}

template void SweepDown<1>(
  const CompactMatrix&, const SweepDiagonal&, const float*, float*, float*);
template void SweepDown<4>(
  const CompactMatrix&, const SweepDiagonal&, const float*, float*, float*);
template void SweepUp<1>(
  const CompactMatrix&, const SweepDiagonal&, const float*, const float*, float*);
template void SweepUp<4>(
  const CompactMatrix&, const SweepDiagonal&, const float*, const float*, float*);
}
