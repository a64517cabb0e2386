// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Sweeps.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace DirectionFields::Internal
{
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
/// This many products are added up in single precision, their sums in double precision.
constexpr Index FewNumbers = 512;

/// The arrays of a matrix. Loops take copies of the pointers, so that the compiler knows that
/// writing values does not change them.
struct Entries
{
  explicit Entries(const CompactMatrix& matrix)
    : Begin(matrix.Begin.data())
    , Inside(matrix.Inside.data())
    , ColumnInBlock(matrix.ColumnInBlock.data())
    , Value(matrix.Value.data())
  {
  }
  const Index* Begin;
  const Index* Inside;
  const std::uint16_t* ColumnInBlock;
  const CompactComplex* Value;

  /// Adds the terms of row v from its own block.
  /// @param x begins with the block
  template <int B>
  void AddInside(Index v, const float* x, CompactValues<B>& sum) const
  {
    AddManyProducts(this->Value, this->ColumnInBlock, this->Begin[v], this->Inside[v], x, sum);
  }
};

/// A copy of the part of sections that belongs to a block. Sums of other blocks read that part and
/// multiply it by zero (see AddManyProducts): they must not read values that a sweep is writing.
template <int B>
class BlockSections
{
public:
  /// @param all the sections; null for sections that are zero
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
  /// The values have room for a whole block: sums may read the value of any of its columns, even if
  /// they multiply it by zero.
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

/// Calls body(v, half) for the rows of a block. The two halves take turns, so that a row does not
/// wait for the one before.
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

/// Calls body(row) for the local rows of a block, LocalSweeps times.
template <typename Body>
void ForLocalRows(
  const CompactMatrix& matrix, Index begin, Index end, SweepOrder order, const Body& body)
{
  const auto from = [&](Index row)
  {
    return std::partition_point(matrix.Local.begin(), matrix.Local.end(),
      [row](const CompactMatrix::LocalRow& local) { return local.Row < row; });
  };
  const auto first = from(begin);
  const auto last = from(end);
  for (int again = 0; again < LocalSweeps; ++again)
  {
    if (order == SweepOrder::Down)
    {
      std::for_each(first, last, body);
    }
    else
    {
      std::for_each(std::make_reverse_iterator(last), std::make_reverse_iterator(first), body);
    }
  }
}

/// Moves row v of a block towards the solution of its equation, by the relaxation.
template <int B>
struct Relaxation
{
  Relaxation(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
    Index begin, float* own)
    : Couplings(matrix)
    , Inverse(diagonal.Inverse.data())
    , Right(b)
    , First(begin)
    , Own(own)
    , Kept(1.0f - diagonal.Relaxation)
  {
  }
  /// @param sum the terms of the row from other blocks
  void operator()(Index v, CompactValues<B> sum) const
  {
    this->AddRest(v, sum);
    sum.AddReal(this->Kept, this->Own, v - this->First);
    sum.Store(this->Own, v - this->First);
  }
  /// The same where the row is zero.
  void FromZero(Index v) const
  {
    CompactValues<B> sum;
    this->AddRest(v, sum);
    sum.Store(this->Own, v - this->First);
  }

private:
  void AddRest(Index v, CompactValues<B>& sum) const
  {
    this->Couplings.template AddInside<B>(v, this->Own, sum);
    sum.AddReal(-1.0f, this->Right, v);
    sum.Scale(-this->Inverse[v]);
  }
  Entries Couplings;
  const float* Inverse;
  const float* Right;
  Index First;
  float* Own;
  float Kept;
};

/// Calls body(j, v, sum) for the rows v of the boundary with their terms from other blocks.
/// @param x the sections at the rows of the boundary
template <int B, typename Body>
void ForBoundary(const CompactMatrix& matrix, const float* x, const Body& body)
{
  ParallelFor(static_cast<Index>(matrix.Boundary.size()), CompactMatrix::PieceRows,
    [x, body, boundary = matrix.Boundary.data(), first = matrix.OutsideBegin.data(),
      columns = matrix.OutsideColumn.data(),
      values = matrix.OutsideValue.data()](Index begin, Index end)
    {
      const Body local = body;
      for (Index j = begin; j < end; ++j)
      {
        CompactValues<B> sum;
        AddProducts(values, columns, first[j], first[j + 1], x, sum);
        local(j, boundary[j], sum);
      }
    });
}

/// Stores the residual of a block that has been swept, without the terms of other blocks, and the
/// block's rows of the boundary.
/// @param x begins with the block
template <int B>
void StoreRestOfBlock(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* x, Index begin, Index end, float* r, CompactSections& boundary)
{
  for (Index j = matrix.BoundaryFrom(begin), last = matrix.BoundaryFrom(end); j < last; ++j)
  {
    CompactValues<B>(x, matrix.Boundary[j] - begin).Store(boundary.data(), j);
  }
  ForRows(begin, end,
    [=, entries = Entries(matrix), d = diagonal.Diagonal.data()](Index v)
    {
      CompactValues<B> sum;
      entries.AddInside<B>(v, x, sum);
      sum.AddReal(d[v], x, v - begin);
      sum.Scale(-1.0f);
      sum.AddReal(1.0f, b, v);
      sum.Store(r, v);
    });
}

/// The scalar product of real numbers.
double Product(const float* x, const float* y, Index count)
{
  double product = 0.0;
  for (Index k = 0; k < count; k += FewNumbers)
  {
    const Index few = std::min(FewNumbers, count - k);
    product += Eigen::Map<const Eigen::VectorXf>(x + k, few)
                 .dot(Eigen::Map<const Eigen::VectorXf>(y + k, few));
  }
  return product;
}

/// Calls sweep(begin, end, own) for each block of x, and finds the residual.
/// @param from    the sections that sweeps begin with; null for zero
/// @param r       b - (A + shift m) x; or null
/// @param product Re b^* x; or null
template <int B, typename SweepBlock>
void SweepBlocks(const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b,
  const float* from, float* x, float* r, double* product, CompactSections& boundary,
  const SweepBlock& sweep)
{
  const auto products = ParallelSum<double>(matrix.Rows(), BlockRows, 0.0,
    [&](Index begin, Index end)
    {
      BlockSections<B> block(from, begin, end);
      sweep(begin, end, block.data());
      block.CopyTo(x);
      if (r)
      {
        StoreRestOfBlock<B>(matrix, diagonal, b, block.data(), begin, end, r, boundary);
      }
      return product
        ? Product(b + static_cast<std::size_t>(2 * B) * begin, block.data(), 2 * B * (end - begin))
        : 0.0;
    });
  if (product)
  {
    *product = products;
  }
  if (!r)
  {
    return;
  }
  ForBoundary<B>(matrix, boundary.data(),
    [r](Index, Index v, CompactValues<B> sum)
    {
      sum.Scale(-1.0f);
      sum.AddReal(1.0f, r, v);
      sum.Store(r, v);
    });
}
}

template <int B>
void SweepFromZero(
  const CompactMatrix& matrix, const SweepDiagonal& diagonal, const float* b, float* x, float* r)
{
  CompactSections boundary(2 * B * matrix.Boundary.size());
  // Rows that have not been swept yet are zero. To multiply by them takes less time than to tell
  // them apart.
  SweepBlocks<B>(matrix, diagonal, b, nullptr, x, r, nullptr, boundary,
    [&](Index begin, Index end, float* own)
    {
      const Relaxation<B> relax(matrix, diagonal, b, begin, own);
      ForBlockRows(begin, end, SweepOrder::Down, [relax](Index v, int) { relax.FromZero(v); });
      ForLocalRows(matrix, begin, end, SweepOrder::Down,
        [&](const CompactMatrix::LocalRow& local) { relax(local.Row, {}); });
    });
}

template <int B>
void Sweep(const CompactMatrix& matrix, const SweepDiagonal& diagonal, SweepOrder order,
  const float* b, float* x, float* r, double* product)
{
  CompactSections boundary(2 * B * matrix.Boundary.size());
  ParallelFor(static_cast<Index>(matrix.Boundary.size()), CompactMatrix::PieceRows,
    [=, rows = matrix.Boundary.data(), to = boundary.data()](Index begin, Index end)
    { ForRows(begin, end, [=](Index j) { CompactValues<B>(x, rows[j]).Store(to, j); }); });
  CompactSections outside(boundary.size());
  ForBoundary<B>(matrix, boundary.data(),
    [from = boundary.data(), extra = diagonal.Extra.data(), to = outside.data()](
      Index j, Index, CompactValues<B> sum)
    {
      sum.AddReal(-extra[j], from, j);
      sum.Store(to, j);
    });
  const bool isDown = order == SweepOrder::Down;
  SweepBlocks<B>(matrix, diagonal, b, x, x, r, product, boundary,
    [&](Index begin, Index end, float* own)
    {
      const Relaxation<B> relax(matrix, diagonal, b, begin, own);
      const auto sweepLocalRows = [&]
      {
        ForLocalRows(matrix, begin, end, order,
          [&](const CompactMatrix::LocalRow& local)
          {
            relax(local.Row,
              local.Boundary == None ? CompactValues<B>()
                                     : CompactValues<B>(outside.data(), local.Boundary));
          });
      };
      if (!isDown)
      {
        sweepLocalRows();
      }
      const Index middle = begin + (end - begin) / 2;
      // The number in the boundary of each half's next row of the boundary; upwards, one more than
      // it.
      std::array<Index, 2> next{ matrix.BoundaryFrom(isDown ? begin : middle),
        matrix.BoundaryFrom(isDown ? middle : end) };
      ForBlockRows(begin, end, order,
        [=, ends = matrix.Begin.data(), inside = matrix.Inside.data(), from = outside.data()](
          Index v, int half) mutable
        {
          CompactValues<B> sum;
          if (inside[v] < ends[v + 1])
          {
            sum.AddReal(1.0f, from, isDown ? next[half]++ : --next[half]);
          }
          relax(v, sum);
        });
      if (isDown)
      {
        sweepLocalRows();
      }
    });
}

template void Sweep<1>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*, float*, double*);
template void Sweep<4>(
  const CompactMatrix&, const SweepDiagonal&, SweepOrder, const float*, float*, float*, double*);
template void SweepFromZero<1>(
  const CompactMatrix&, const SweepDiagonal&, const float*, float*, float*);
template void SweepFromZero<4>(
  const CompactMatrix&, const SweepDiagonal&, const float*, float*, float*);
}
