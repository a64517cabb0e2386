// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CompactMatrix.h"

#include "Threads.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields
{
CompactMatrix::CompactMatrix(const SparseMatrix& matrix)
{
  const auto rows = static_cast<Index>(matrix.cols());
  const auto entries = static_cast<std::size_t>(matrix.nonZeros()) - rows;
  this->Begin.resize(rows + 1);
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

SweepDiagonal::SweepDiagonal(
  const CompactMatrix& matrix, const LargeArray<float>& m, float shift, float relaxation)
  : Relaxation(relaxation)
  , Diagonal(matrix.Diagonal)
  , Inverse(matrix.Rows())
  , Extra(matrix.Boundary.size(), 0.0f)
{
  ParallelFor(matrix.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        this->Diagonal[v] += shift * m[v];
        this->Inverse[v] = relaxation / this->Diagonal[v];
      }
    });
  for (std::size_t j = 0; j < matrix.Boundary.size(); ++j)
  {
    const Index v = matrix.Boundary[j];
    for (Index k = matrix.Inside[v]; k < matrix.Begin[v + 1]; ++k)
    {
      this->Extra[j] += Modulus(matrix.Value[k]);
    }
    this->Inverse[v] = relaxation / (this->Diagonal[v] + this->Extra[j]);
  }
}

namespace
{
constexpr Index BlockRows = CompactMatrix::BlockRows;

/// The first row of the boundary, counted in it, from a row on.
Index BoundaryFrom(const CompactMatrix& matrix, Index row)
{
  const LargeArray<Index>& boundary = matrix.Boundary;
  return static_cast<Index>(
    std::lower_bound(boundary.begin(), boundary.end(), row) - boundary.begin());
}

/// Calls body(v, half) for the rows of a block. The two halves take turns, so that a row does not wait
/// for the one before.
template <typename Body>
void ForBlockRows(Index begin, Index middle, Index end, SweepOrder order, const Body& body)
{
  const Index half = middle - begin;
  if (order == SweepOrder::Down)
  {
    for (Index i = 0; i < half; ++i)
    {
      body(begin + i, 0);
      body(middle + i, 1);
    }
  }
  // The second half may have one more.
  if (middle + half < end)
  {
    body(middle + half, 1);
  }
  if (order == SweepOrder::Up)
  {
    for (Index i = half; i-- > 0;)
    {
      body(middle + i, 1);
      body(begin + i, 0);
    }
  }
}

/// Sweeps the rows of a block.
/// @param outside what the rows of the boundary get from other blocks; or null
template <int B>
void SweepBlock(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, const float* outside, Index begin, Index end, float* x)
{
  const Index middle = begin + (end - begin) / 2;
  const float kept = 1.0f - diagonal.Relaxation;
  const auto sweep = [&](Index v, CompactValues<B>& sum)
  {
    AddManyProducts<B>(matrix.Value.data(), matrix.Column.data(), matrix.Begin[v],
      matrix.Inside[v], x, sum);
    sum.AddReal(-1.0f, b, v);
    sum.Scale(-diagonal.Inverse[v]);
    sum.AddReal(kept, x, v);
    sum.Store(x, v);
  };
  if (!outside)
  {
    ForBlockRows(begin, middle, end, order,
      [&](Index v, int)
      {
        CompactValues<B> sum;
        sweep(v, sum);
      });
    return;
  }
  const bool isDown = order == SweepOrder::Down;
  // Of the next row of the boundary in each half; upwards, of the one before.
  std::array<Index, 2> next{ BoundaryFrom(matrix, isDown ? begin : middle),
    BoundaryFrom(matrix, isDown ? middle : end) };
  ForBlockRows(begin, middle, end, order,
    [&](Index v, int half)
    {
      CompactValues<B> sum;
      if (matrix.Inside[v] < matrix.Begin[v + 1])
      {
        sum.AddReal(1.0f, outside, isDown ? next[half]++ : --next[half]);
      }
      sweep(v, sum);
    });
}
}

template <int B>
void SweepFromZero(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x)
{
  ParallelFor(matrix.Rows(), BlockRows,
    [&](Index begin, Index end)
    {
      // Products with zeros take less time than to tell which rows come first.
      std::fill(x + static_cast<std::size_t>(2 * B) * begin,
        x + static_cast<std::size_t>(2 * B) * end, 0.0f);
      SweepBlock<B>(matrix, diagonal, order, b, nullptr, begin, end, x);
    });
}

template <int B>
void Sweep(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x)
{
  CompactSections outside(2 * B * matrix.Boundary.size());
  ParallelFor(static_cast<Index>(matrix.Boundary.size()), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index j = begin; j < end; ++j)
      {
        const Index v = matrix.Boundary[j];
        CompactValues<B> sum;
        AddProducts<B>(matrix.Value.data(), matrix.Column.data(), matrix.Inside[v],
          matrix.Begin[v + 1], x, sum);
        sum.AddReal(-diagonal.Extra[j], x, v);
        sum.Store(outside.data(), j);
      }
    });
  ParallelFor(matrix.Rows(), BlockRows,
    [&](Index begin, Index end)
    { SweepBlock<B>(matrix, diagonal, order, b, outside.data(), begin, end, x); });
}

template <int B>
void Rest(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* x, float* r)
{
  ParallelFor(matrix.Rows(), CompactMatrix::PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> sum;
        sum.AddReal(diagonal.Diagonal[v], x, v);
        AddManyProducts<B>(matrix.Value.data(), matrix.Column.data(), matrix.Begin[v],
          matrix.Begin[v + 1], x, sum);
        sum.AddReal(-1.0f, b, v);
        sum.Scale(-1.0f);
        sum.Store(r, v);
      }
    });
}

template void Sweep<1>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*);
template void Sweep<4>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*);
template void SweepFromZero<1>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*);
template void SweepFromZero<4>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*);
template void Rest<1>(
  const CompactMatrix&, const SweepDiagonal&, const float*, const float*, float*);
template void Rest<4>(
  const CompactMatrix&, const SweepDiagonal&, const float*, const float*, float*);
}
