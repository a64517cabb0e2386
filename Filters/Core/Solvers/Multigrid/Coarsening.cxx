// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Multigrid/Coarsening.h"

#include "Solvers/Matrices/RowSum.h"
#include "Solvers/Multigrid/Aggregation.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace DirectionFields
{
namespace
{
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// Damping of the prolongator's smoothing, over the largest eigenvalue.
constexpr float Damping = 4.0f / 3.0f;
/// Likewise where it stays within its pattern; it would diverge from 2 on.
constexpr float DampingWithinPattern = 1.9f;
/// Parts of the rows of a prolongator that are transposed at once.
constexpr Index AdjointParts = 8;
/// Rows of a piece that tell about how much storage it will take.
constexpr Index FirstRows = 64;

/// Rows made in pieces, put one after the other.
template <typename Entry>
struct Rows
{
  LargeArray<Index> Size;
  std::vector<std::vector<std::pair<Index, Entry>>> Pieces;

  /// @param sorted whether the entries of a row are in the order of their columns, each of which comes
  ///               once then
  template <typename MakeRow>
  Rows(Index count, bool sorted, const MakeRow& makeRow)
    : Size(count)
    , Pieces(NumberOfPieces(count, PieceRows))
  {
    ParallelFor(count, PieceRows,
      [&](Index begin, Index end)
      {
        RowSum<Entry> sum;
        auto& piece = this->Pieces[begin / PieceRows];
        for (Index row = begin; row < end; ++row)
        {
          if (row == begin + FirstRows)
          {
            piece.reserve(piece.size() * (end - begin) / FirstRows * 9 / 8);
          }
          makeRow(row, sum);
          const auto take = [&](auto first, auto last)
          {
            this->Size[row] = static_cast<Index>(last - first);
            piece.insert(piece.end(), first, last);
          };
          sorted ? sum.TakeSorted(take) : sum.Take(take);
        }
      });
  }

  /// begin[row], begin of the first row 0.
  LargeArray<Index> Begin() const
  {
    LargeArray<Index> begin(this->Size.size() + 1);
    begin[0] = 0;
    std::partial_sum(this->Size.begin(), this->Size.end(), begin.begin() + 1);
    return begin;
  }

  /// Calls visit(row, entry) for all entries, each piece in order.
  template <typename Visit>
  void ForEach(const Visit& visit) const
  {
    ParallelFor(static_cast<Index>(this->Size.size()), PieceRows,
      [&](Index begin, Index end)
      {
        auto entry = this->Pieces[begin / PieceRows].begin();
        for (Index row = begin; row < end; ++row)
        {
          for (Index k = 0; k < this->Size[row]; ++k)
          {
            visit(row, k, *entry++);
          }
        }
      });
  }
};

/// Entries added up for a few columns, as many as nearly all rows of a prolongator have.
struct FewColumns
{
  static constexpr int Count = 4;
  using Numbers = Eigen::Array<float, Count, 1>;

  Index First;
  /// Of the columns from the first one.
  Numbers Distance;
  Numbers Real = Numbers::Zero();
  Numbers Imaginary = Numbers::Zero();

  FewColumns(const Index* columns, Index count)
    : First(*columns)
  {
    for (int c = 0; c < Count; ++c)
    {
      this->Distance[c] = c < count ? static_cast<float>(columns[c] - this->First)
                                    : std::numeric_limits<float>::infinity();
    }
  }
  /// Where it is one of the columns; without a branch.
  void Add(Index column, const CompactComplex& value)
  {
    const Numbers isSame =
      (1.0f - (this->Distance - static_cast<float>(column - this->First)).abs()).max(0.0f);
    this->Real += isSame * value.real();
    this->Imaginary += isSame * value.imag();
  }
};

/// 0 of 0.
CompactComplex Phase(const CompactComplex& value)
{
  return value * (1.0f / std::max(Modulus(value), std::numeric_limits<float>::min()));
}

/// One step towards columns of least energy that keeps the pattern and what transported constants are
/// interpolated to.
/// @param perRadius over what bounds the largest eigenvalue, times the diagonal
void LowerEnergy(const CompactMatrix& energy, const Couplings& couplings,
  const LargeArray<float>& perRadius, Prolongator& p)
{
  LargeArray<CompactComplex> lowered;
  ResizePadded(lowered, p.Begin.back());
  ParallelFor(energy.Rows(), PieceRows,
    [to = lowered.data(), begins = p.Begin.data(), columns = p.Column.data(),
      values = p.Value.data(), rows = energy.Begin.data(), neighbours = energy.Column.data(),
      entries = energy.Value.data(), strength = couplings.Strength.data(),
      diagonal = couplings.Diagonal.data(), perRadius = perRadius.data()](Index begin, Index end)
    {
      std::vector<CompactComplex> phases;
      for (Index i = begin; i < end; ++i)
      {
        const Index first = begins[i];
        const Index count = begins[i + 1] - first;
        if (count < 2)
        {
          std::copy_n(values + first, count, to + first);
          continue;
        }
        // Of row i of A P what is within the pattern.
        phases.resize(count);
        CompactComplex along = 0.0f;
        for (Index at = 0; at < count; at += FewColumns::Count)
        {
          FewColumns sum(columns + first + at, count - at);
          for (Index k = rows[i]; k < rows[i + 1]; ++k)
          {
            if (strength[k] > 0.0f)
            {
              const Index j = neighbours[k];
              for (Index e = begins[j]; e < begins[j + 1]; ++e)
              {
                sum.Add(columns[e], entries[k] * values[e]);
              }
            }
          }
          for (Index c = at; c < std::min(at + FewColumns::Count, count); ++c)
          {
            const CompactComplex value = values[first + c];
            const CompactComplex product = diagonal[i] * value +
              CompactComplex(sum.Real[c - at], sum.Imaginary[c - at]);
            phases[c] = Phase(value);
            along += std::conj(phases[c]) * product;
            to[first + c] = product;
          }
        }
        along /= static_cast<float>(count);
        const float step = DampingWithinPattern * perRadius[i];
        for (Index c = 0; c < count; ++c)
        {
          to[first + c] = values[first + c] - step * (to[first + c] - along * phases[c]);
        }
      }
    });
  p.Value.swap(lowered);
}

/// P^*, its rows in ascending order of the fine vertices.
void AddAdjoint(Prolongator& p, Index coarse)
{
  // Each of some parts of the rows counts its entries in each column, then knows where they go.
  const Index rows = p.FineRows();
  const Index partRows = std::max(PieceRows, rows / AdjointParts + 1);
  std::vector<std::vector<Index>> at(NumberOfPieces(rows, partRows));
  ParallelFor(rows, partRows,
    [&](Index begin, Index end)
    {
      std::vector<Index>& counts = at[begin / partRows];
      counts.assign(coarse, 0);
      for (Index k = p.Begin[begin]; k < p.Begin[end]; ++k)
      {
        ++counts[p.Column[k]];
      }
    });
  p.AdjointBegin.resize(coarse + 1);
  Index place = 0;
  for (Index column = 0; column < coarse; ++column)
  {
    p.AdjointBegin[column] = place;
    for (std::vector<Index>& counts : at)
    {
      const Index count = counts[column];
      counts[column] = place;
      place += count;
    }
  }
  p.AdjointBegin[coarse] = place;
  ResizePadded(p.AdjointColumn, place);
  ResizePadded(p.AdjointValue, place);
  ParallelFor(rows, partRows,
    [&](Index begin, Index end)
    {
      std::vector<Index>& places = at[begin / partRows];
      for (Index row = begin; row < end; ++row)
      {
        for (Index k = p.Begin[row]; k < p.Begin[row + 1]; ++k)
        {
          const Index to = places[p.Column[k]]++;
          p.AdjointColumn[to] = row;
          p.AdjointValue[to] = std::conj(p.Value[k]);
        }
      }
    });
}

/// An entry of the energy and one of the mass, whose real and imaginary parts fit a register together.
struct TwoEntries
{
  using Numbers = Eigen::Array4f;

  std::array<float, 4> Parts{};

  CompactComplex Energy() const { return { this->Parts[0], this->Parts[1] }; }
  CompactComplex Mass() const { return { this->Parts[2], this->Parts[3] }; }
  void Add(const Numbers& numbers)
  {
    Eigen::Map<Numbers> own(this->Parts.data());
    own += numbers;
  }
  TwoEntries& operator+=(const TwoEntries& other)
  {
    this->Add(Eigen::Map<const Numbers>(other.Parts.data()));
    return *this;
  }
};

/// Products of two numbers with others.
class TwoFactors
{
public:
  TwoFactors(const CompactComplex& energy, const CompactComplex& mass)
    : Both(energy.real(), energy.imag(), mass.real(), mass.imag())
    , Turned(-energy.imag(), energy.real(), -mass.imag(), mass.real())
  {
  }
  TwoEntries::Numbers Times(const CompactComplex& other) const
  {
    return this->Both * other.real() + this->Turned * other.imag();
  }

private:
  TwoEntries::Numbers Both;
  /// Times i.
  TwoEntries::Numbers Turned;
};
}

template <int B>
void LevelMatrices::Multiply(const float* x, float* ax, float* mx) const
{
  const CompactMatrix& energy = this->Energy;
  ParallelFor(energy.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        CompactValues<B> a;
        CompactValues<B> m;
        a.AddReal(energy.Diagonal[v], x, v);
        m.AddReal(this->MassDiagonal[v], x, v);
        for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
        {
          a.Add(energy.Value[k], x, energy.Column[k]);
          m.Add(this->MassValue[k], x, energy.Column[k]);
        }
        a.Store(ax, v);
        m.Store(mx, v);
      }
    });
}

template void LevelMatrices::Multiply<4>(const float*, float*, float*) const;

template <int B>
void Prolongator::Prolong(const float* y, float* x) const
{
  ParallelFor(this->FineRows(), PieceRows,
    [y, x, first = this->Begin.data(), columns = this->Column.data(),
      values = this->Value.data()](Index begin, Index end)
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
    [y, x, first = this->Begin.data(), columns = this->Column.data(),
      values = this->Value.data()](Index begin, Index end)
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

template void Prolongator::Prolong<1>(const float*, float*) const;
template void Prolongator::Prolong<4>(const float*, float*) const;
template void Prolongator::AddTo<1>(float*, const float*) const;
template void Prolongator::AddTo<4>(float*, const float*) const;
template void Prolongator::Restrict<1>(const float*, float*) const;
template void Prolongator::Restrict<4>(const float*, float*) const;

Prolongator MakeProlongator(const LevelMatrices& matrices, int level, LeftOver leftOver)
{
  const CompactMatrix& energy = matrices.Energy;
  const Couplings couplings = FindCouplings(matrices, level);
  const Aggregates aggregates = Aggregate(matrices, couplings, leftOver);
  // The inverse of what bounds the largest eigenvalue, times the diagonal.
  LargeArray<float> perRadius(energy.Rows());
  const Rows<CompactComplex> rows(energy.Rows(), true,
    [&](Index i, RowSum<CompactComplex>& sum)
    {
      perRadius[i] = 0.0f;
      if (aggregates.Number[i] == None)
      {
        return;
      }
      float radius = couplings.Diagonal[i];
      for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
      {
        radius += couplings.Strength[k] > 0.0f ? Modulus(energy.Value[k]) : 0.0f;
      }
      perRadius[i] = 1.0f / radius;
      const float step = Damping * perRadius[i];
      sum[aggregates.Number[i]] += (1.0f - step * couplings.Diagonal[i]) * aggregates.Phase[i];
      for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
      {
        const Index j = energy.Column[k];
        // Rounding may make a coupling strong on one side only, and the other vertex was left out.
        if (couplings.Strength[k] > 0.0f && aggregates.Number[j] != None)
        {
          sum[aggregates.Number[j]] -= step * energy.Value[k] * aggregates.Phase[j];
        }
      }
    });
  Prolongator p;
  p.Begin = rows.Begin();
  ResizePadded(p.Column, p.Begin.back());
  ResizePadded(p.Value, p.Begin.back());
  rows.ForEach(
    [&](Index row, Index k, const std::pair<Index, CompactComplex>& entry)
    {
      p.Column[p.Begin[row] + k] = entry.first;
      p.Value[p.Begin[row] + k] = entry.second;
    });
  LowerEnergy(energy, couplings, perRadius, p);
  AddAdjoint(p, aggregates.Count);
  return p;
}

LevelMatrices Coarsen(const LevelMatrices& matrices, const Prolongator& prolongator)
{
  const CompactMatrix& energy = matrices.Energy;
  // A P and M P first.
  const Rows<TwoEntries> products(energy.Rows(), false,
    [&](Index i, RowSum<TwoEntries>& sum)
    {
      const auto add = [&](Index j, const CompactComplex& a, const CompactComplex& m)
      {
        const TwoFactors factors(a, m);
        for (Index k = prolongator.Begin[j]; k < prolongator.Begin[j + 1]; ++k)
        {
          sum[prolongator.Column[k]].Add(factors.Times(prolongator.Value[k]));
        }
      };
      add(i, energy.Diagonal[i], matrices.MassDiagonal[i]);
      for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
      {
        add(energy.Column[k], energy.Value[k], matrices.MassValue[k]);
      }
    });
  const LargeArray<Index> begin = products.Begin();
  const Rows<TwoEntries> rows(prolongator.CoarseRows(), true,
    [&](Index row, RowSum<TwoEntries>& sum)
    {
      for (Index k = prolongator.AdjointBegin[row]; k < prolongator.AdjointBegin[row + 1]; ++k)
      {
        const Index i = prolongator.AdjointColumn[k];
        const Index piece = i / PieceRows;
        const auto* entry = products.Pieces[piece].data() + (begin[i] - begin[piece * PieceRows]);
        for (Index e = 0; e < products.Size[i]; ++e, ++entry)
        {
          const TwoFactors factors(entry->second.Energy(), entry->second.Mass());
          sum[entry->first].Add(factors.Times(prolongator.AdjointValue[k]));
        }
      }
    });
  const Index n = prolongator.CoarseRows();
  const LargeArray<Index> rowBegin = rows.Begin();
  LevelMatrices coarse;
  coarse.Energy.Begin.resize(n + 1);
  coarse.Energy.Diagonal.resize(n);
  coarse.MassDiagonal.resize(n);
  coarse.Energy.Begin[n] = rowBegin[n] - n;
  ResizePadded(coarse.Energy.Column, rowBegin[n] - n);
  ResizePadded(coarse.Energy.Value, rowBegin[n] - n);
  coarse.MassValue.resize(rowBegin[n] - n);
  rows.ForEach(
    [&](Index row, Index k, const std::pair<Index, TwoEntries>& entry)
    {
      const Index start = rowBegin[row] - row;
      if (k == 0)
      {
        coarse.Energy.Begin[row] = start;
      }
      if (entry.first == row)
      {
        coarse.Energy.Diagonal[row] = entry.second.Energy().real();
        coarse.MassDiagonal[row] = entry.second.Mass().real();
        return;
      }
      const Index at = start + k - (entry.first > row ? 1 : 0);
      coarse.Energy.Column[at] = entry.first;
      coarse.Energy.Value[at] = entry.second.Energy();
      coarse.MassValue[at] = entry.second.Mass();
    });
  coarse.Energy.OrderByBlocks(&coarse.MassValue);
  return coarse;
}
}
