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
  ResizePadded(this->ColumnInBlock, this->Entries());
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
        for (Index k = first; k < last; ++k)
        {
          const Index inside = in + (k - first);
          this->ColumnInBlock[k] =
            static_cast<std::uint16_t>(inside < out ? this->Column[inside] - begin : 0);
        }
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

/// The arrays of a matrix. Loops take copies: what they write could not change those.
struct Entries
{
  explicit Entries(const CompactMatrix& matrix)
    : Begin(matrix.Begin.data())
    , Inside(matrix.Inside.data())
    , Column(matrix.Column.data())
    , ColumnInBlock(matrix.ColumnInBlock.data())
    , Value(matrix.Value.data())
  {
  }
  const Index* Begin;
  const Index* Inside;
  const Index* Column;
  const std::uint16_t* ColumnInBlock;
  const CompactComplex* Value;

  /// Adds what row v gets from its own block.
  /// @param x begins with the block
  template <int B>
  void AddInside(Index v, const float* x, CompactValues<B>& sum) const
  {
    AddManyProducts(this->Value, this->ColumnInBlock, this->Begin[v], this->Inside[v], x, sum);
  }
  template <int B>
  void AddOutside(Index v, const float* x, CompactValues<B>& sum) const
  {
    AddProducts(this->Value, this->Column, this->Inside[v], this->Begin[v + 1], x, sum);
  }
};

/// A copy of the part of sections that belongs to a block: a sweep that changed the part itself would
/// change what sums of other blocks look at, if only to hide it.
template <int B>
class BlockSections
{
public:
  /// @param all zero if null
  BlockSections(const float* all, Index begin, Index end)
    : First(static_cast<std::size_t>(2 * B) * begin)
    , Size(static_cast<std::size_t>(2 * B) * (end - begin))
  {
    if (all)
    {
      std::copy_n(all + this->First, this->Size, this->Values.data());
    }
    std::fill(this->Values.begin() + (all ? this->Size : 0), this->Values.end(), 0.0f);
  }
  float* data() { return this->Values.data(); }
  void CopyTo(float* all) const { std::copy_n(this->Values.data(), this->Size, all + this->First); }

private:
  std::size_t First;
  std::size_t Size;
  /// As many as columns may refer to that sums hide.
  std::array<float, static_cast<std::size_t>(2 * B) * BlockRows> Values;
};

template <typename Body>
void ForRows(Index begin, Index end, Body body)
{
  for (Index v = begin; v < end; ++v)
  {
    body(v);
  }
}

/// Calls body(v, half) for the rows of a block. The two halves take turns, so that a row does not wait
/// for the one before.
template <typename Body>
void ForBlockRows(Index begin, Index end, SweepOrder order, Body body)
{
  const Index half = (end - begin) / 2;
  const Index middle = begin + half;
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

/// Calls body(j, v) for the rows v of the boundary.
template <typename Body>
void ForBoundary(const CompactMatrix& matrix, const Body& body)
{
  ParallelFor(static_cast<Index>(matrix.Boundary.size()), CompactMatrix::PieceRows,
    [boundary = matrix.Boundary.data(), body](Index begin, Index end)
    {
      const Body local = body;
      for (Index j = begin; j < end; ++j)
      {
        local(j, boundary[j]);
      }
    });
}

/// b - d x - sum in row v of b.
template <int B>
void StoreRest(CompactValues<B> sum, float d, const float* x, Index at, const float* b, Index v,
  float* r)
{
  sum.AddReal(d, x, at);
  sum.Scale(-1.0f);
  sum.AddReal(1.0f, b, v);
  sum.Store(r, v);
}
}

template <int B>
void SweepFromZero(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  float* x, float* r)
{
  const Entries entries(matrix);
  ParallelFor(matrix.Rows(), BlockRows,
    [=, &diagonal](Index begin, Index end)
    {
      BlockSections<B> block(nullptr, begin, end);
      // Products with zeros take less time than to tell which rows come first.
      ForBlockRows(begin, end, SweepOrder::Down,
        [=, inverse = diagonal.Inverse.data(), own = block.data()](Index v, int)
        {
          CompactValues<B> sum;
          entries.AddInside<B>(v, own, sum);
          sum.AddReal(-1.0f, b, v);
          sum.Scale(-inverse[v]);
          sum.Store(own, v - begin);
        });
      block.CopyTo(x);
      if (!r)
      {
        return;
      }
      // The block's part of the matrix is still in the cache.
      ForRows(begin, end,
        [=, d = diagonal.Diagonal.data(), own = block.data()](Index v)
        {
          CompactValues<B> sum;
          entries.AddInside<B>(v, own, sum);
          StoreRest<B>(sum, d[v], own, v - begin, b, v, r);
        });
    });
  if (r)
  {
    ForBoundary(matrix,
      [=](Index, Index v)
      {
        CompactValues<B> sum;
        entries.AddOutside<B>(v, x, sum);
        sum.Scale(-1.0f);
        sum.AddReal(1.0f, r, v);
        sum.Store(r, v);
      });
  }
}

template <int B>
void Sweep(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x)
{
  const Entries entries(matrix);
  CompactSections outside(2 * B * matrix.Boundary.size());
  ForBoundary(matrix,
    [=, extra = diagonal.Extra.data(), to = outside.data()](Index j, Index v)
    {
      CompactValues<B> sum;
      entries.AddOutside<B>(v, x, sum);
      sum.AddReal(-extra[j], x, v);
      sum.Store(to, j);
    });
  const bool isDown = order == SweepOrder::Down;
  ParallelFor(matrix.Rows(), BlockRows,
    [=, &matrix, &diagonal, &outside](Index begin, Index end)
    {
      const Index middle = begin + (end - begin) / 2;
      // Of the next row of the boundary in each half; upwards, of the one before.
      std::array<Index, 2> next{ BoundaryFrom(matrix, isDown ? begin : middle),
        BoundaryFrom(matrix, isDown ? middle : end) };
      BlockSections<B> block(x, begin, end);
      ForBlockRows(begin, end, order,
        [=, kept = 1.0f - diagonal.Relaxation, inverse = diagonal.Inverse.data(),
          from = outside.data(), own = block.data()](Index v, int half) mutable
        {
          CompactValues<B> sum;
          if (entries.Inside[v] < entries.Begin[v + 1])
          {
            sum.AddReal(1.0f, from, isDown ? next[half]++ : --next[half]);
          }
          entries.AddInside<B>(v, own, sum);
          sum.AddReal(-1.0f, b, v);
          sum.Scale(-inverse[v]);
          sum.AddReal(kept, own, v - begin);
          sum.Store(own, v - begin);
        });
      block.CopyTo(x);
    });
}

template <int B>
void Rest(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* x, float* r)
{
  ParallelFor(matrix.Rows(), CompactMatrix::PieceRows,
    [=, entries = Entries(matrix), d = diagonal.Diagonal.data()](Index begin, Index end)
    {
      ForRows(begin, end,
        [=](Index v)
        {
          CompactValues<B> sum;
          AddManyProducts(
            entries.Value, entries.Column, entries.Begin[v], entries.Begin[v + 1], x, sum);
          StoreRest<B>(sum, d[v], x, v, b, v, r);
        });
    });
}

template void Sweep<1>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*);
template void Sweep<4>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*);
template void SweepFromZero<1>(
  const CompactMatrix&, const SweepDiagonal&, const float*, float*, float*);
template void SweepFromZero<4>(
  const CompactMatrix&, const SweepDiagonal&, const float*, float*, float*);
template void Rest<1>(
  const CompactMatrix&, const SweepDiagonal&, const float*, const float*, float*);
template void Rest<4>(
  const CompactMatrix&, const SweepDiagonal&, const float*, const float*, float*);
}
