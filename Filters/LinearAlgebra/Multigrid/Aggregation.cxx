// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Multigrid/Aggregation.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// A coupling is strong above this part of the geometric mean of the two diagonal entries (Vaněk, Mandel,
/// Brezina 1996). From level to level the part is multiplied by StrongPartDecay. Where triangles are
/// stretched this keeps couplings across the stretch out of the aggregates: along these sweeps do not smooth.
constexpr float StrongPart = 0.08f;
constexpr float StrongPartDecay = 0.7f;
/// Weak couplings that are lumped into the diagonal leave at least this part of it.
constexpr float LeastFilteredDiagonal = 0.3f;
/// Sweeps solve for a vertex whose couplings add up to no more than this part of its diagonal entry.
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

/// Makes an aggregate of each vertex that is coupled strongly, yet with no vertex of an aggregate so far:
/// the vertex is the root, its neighbours by strong couplings belong to it.
void AggregateNeighbourhoods(
  const LevelMatrices& matrices, const Couplings& couplings, Aggregates& aggregates)
{
  const CompactMatrix& energy = matrices.Energy;
  for (Index root = 0; root < energy.Rows(); ++root)
  {
    if (aggregates.Number[root] != None)
    {
      continue;
    }
    bool free = true;
    bool coupled = false;
    for (Index k = energy.Begin[root]; free && k < energy.Begin[root + 1]; ++k)
    {
      coupled = coupled || couplings.Strength[k] > 0.0f;
      free = couplings.Strength[k] == 0.0f || aggregates.Number[energy.Column[k]] == None;
    }
    if (!free || !coupled)
    {
      continue;
    }
    aggregates.Number[root] = aggregates.Count;
    for (Index k = energy.Begin[root]; k < energy.Begin[root + 1]; ++k)
    {
      if (couplings.Strength[k] > 0.0f)
      {
        const Index v = energy.Column[k];
        aggregates.Number[v] = aggregates.Count;
        aggregates.Phase[v] = std::conj(Transport(matrices.MassValue[k]));
      }
    }
    ++aggregates.Count;
  }
}

/// The aggregate of a vertex' strongest neighbour that has one, whose phase is transported to the vertex;
/// None if no neighbour has one.
/// @param number the aggregates to join
Index Join(const LevelMatrices& matrices, const Couplings& couplings, Index v,
  const LargeArray<Index>& number, LargeArray<CompactComplex>& phase)
{
  const CompactMatrix& energy = matrices.Energy;
  Index best = None;
  float strongest = 0.0f;
  for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
  {
    if (couplings.Strength[k] > strongest && number[energy.Column[k]] != None)
    {
      strongest = couplings.Strength[k];
      best = k;
    }
  }
  if (best == None)
  {
    return None;
  }
  const Index neighbour = energy.Column[best];
  phase[v] = Transport(matrices.MassValue[best]) * phase[neighbour];
  return number[neighbour];
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
  Aggregates aggregates{ LargeArray<Index>(n, None), LargeArray<CompactComplex>(n, 1.0f), 0 };
  AggregateNeighbourhoods(matrices, couplings, aggregates);
  // Vertices next to a neighbourhood join it, on several threads: the neighbourhoods do not change.
  const LargeArray<Index> neighbourhoods = aggregates.Number;
  std::vector<std::vector<Index>> left(NumberOfPieces(n, PieceRows));
  ParallelFor(n, PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (neighbourhoods[v] == None)
        {
          aggregates.Number[v] = Join(matrices, couplings, v, neighbourhoods, aggregates.Phase);
        }
        if (aggregates.Number[v] == None)
        {
          left[begin / PieceRows].push_back(v);
        }
      }
    });
  // Others join vertices that have joined one before, or they are left over.
  for (const std::vector<Index>& piece : left)
  {
    for (const Index v : piece)
    {
      aggregates.Number[v] = Join(matrices, couplings, v, aggregates.Number, aggregates.Phase);
      if (aggregates.Number[v] == None && !(leftOver == LeftOver::Drop && IsDominant(energy, v)))
      {
        aggregates.Number[v] = aggregates.Count++;
      }
    }
  }
  return aggregates;
}
}
