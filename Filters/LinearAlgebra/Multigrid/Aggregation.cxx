// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Aggregation.h"

#include "Matrices/StrongAggregates.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// A coupling is strong above this part of the geometric mean of the two diagonal entries (Vaněk,
/// Mandel, Brezina 1996). From level to level the part is multiplied by StrongPartDecay. Where
/// triangles are stretched this keeps couplings across the stretch out of the aggregates: along
/// these sweeps do not smooth.
constexpr float StrongPart = 0.08f;
constexpr float StrongPartDecay = 0.7f;
/// Weak couplings that are lumped into the diagonal leave at least this part of it.
constexpr float LeastFilteredDiagonal = 0.3f;
/// Sweeps solve for a vertex whose couplings add up to no more than this part of its diagonal
/// entry.
constexpr float FewCouplings = 0.9f;

/// The transport from the column's vertex to the row's: the phase of the mass matrix' entry.
CompactComplex Transport(const CompactComplex& mass)
{
  const float size = Modulus(mass);
  return size > 0.0f ? mass / size : CompactComplex(1.0f);
}

/// Whether sweeps solve for a vertex.
bool IsDominant(const CompactMatrix& energy, Index v)
{
  float couplings = 0.0f;
  for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
  {
    couplings += Modulus(energy.Value[k]);
  }
  return couplings <= FewCouplings * energy.Diagonal[v];
}
}

Couplings FindCouplings(const LevelMatrices& matrices, int level)
{
  const CompactMatrix& energy = matrices.Energy;
  const float part = StrongPart * std::pow(StrongPartDecay, static_cast<float>(level));
  Couplings couplings{ LargeArray<float>(energy.Entries()), energy.Diagonal };
  ParallelFor(energy.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        float lumped = energy.Diagonal[i];
        for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
        {
          const float along =
            (energy.Value[k] * std::conj(Transport(matrices.MassValue[k]))).real();
          const float bound = part * part * energy.Diagonal[i] * energy.Diagonal[energy.Column[k]];
          const bool strong = along < 0.0f && along * along > bound;
          couplings.Strength[k] = strong ? -along : 0.0f;
          lumped += strong ? 0.0f : along;
        }
        couplings.Diagonal[i] = std::max(lumped, LeastFilteredDiagonal * energy.Diagonal[i]);
      }
    });
  return couplings;
}

Aggregates Aggregate(const LevelMatrices& matrices, const Couplings& couplings, LeftOver leftOver)
{
  const CompactMatrix& energy = matrices.Energy;
  const Index n = energy.Rows();
  Aggregates aggregates{ {}, LargeArray<CompactComplex>(n, 1.0f), 0 };
  aggregates.Count = AggregateStrongly(
    { n, energy.Begin.data(), energy.Column.data(), couplings.Strength.data() }, aggregates.Number,
    [&](Index k)
    { aggregates.Phase[energy.Column[k]] = std::conj(Transport(matrices.MassValue[k])); },
    [&](Index v, Index k) {
      aggregates.Phase[v] = Transport(matrices.MassValue[k]) * aggregates.Phase[energy.Column[k]];
    },
    [&](Index v) { return leftOver == LeftOver::Keep || !IsDominant(energy, v); });
  return aggregates;
}
}
