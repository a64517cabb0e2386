// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/SmoothedAggregation.h"

#include "Matrices/RowSum.h"
#include "Support/Threads.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// Damping of the prolongator's smoothing, over the largest eigenvalue.
constexpr float Damping = 4.0f / 3.0f;
/// The same for the step that keeps the pattern; with 2 or more it would diverge.
constexpr float DampingWithinPattern = 1.9f;

/// Entries added up for a few columns, as many as nearly all rows of a prolongator have.
struct FewColumns
{
  static constexpr int Count = 4;
  using Numbers = Eigen::Array<float, Count, 1>;

  Index First;
  /// The differences of the columns' numbers from the first one.
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
  /// Adds the value to that of the column, if it is one of the few; without a branch.
  void Add(Index column, const CompactComplex& value)
  {
    const Numbers isSame =
      (1.0f - (this->Distance - static_cast<float>(column - this->First)).abs()).max(0.0f);
    this->Real += isSame * value.real();
    this->Imaginary += isSame * value.imag();
  }
};

/// z / |z|; 0 where z is 0.
CompactComplex Phase(const CompactComplex& z)
{
  return z * (1.0f / std::max(Modulus(z), std::numeric_limits<float>::min()));
}

/// One step towards columns of least energy that keeps the pattern and the interpolation of
/// transported constants.
/// @param perRadius 1 over a bound of the largest eigenvalue times the diagonal
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
        // The entries of row i of A P within the pattern of P.
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
            const CompactComplex product =
              diagonal[i] * value + CompactComplex(sum.Real[c - at], sum.Imaginary[c - at]);
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
}

Prolongator MakeProlongator(const LevelMatrices& matrices, int level, LeftOver leftOver)
{
  const CompactMatrix& energy = matrices.Energy;
  const Couplings couplings = FindCouplings(matrices, level);
  const Aggregates aggregates = Aggregate(matrices, couplings, leftOver);
  // 1 over a bound of the largest eigenvalue times the diagonal.
  LargeArray<float> perRadius(energy.Rows());
  const SummedRows<CompactComplex> rows(energy.Rows(), true,
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
  p.AddAdjoint(aggregates.Count);
  return p;
}
}
