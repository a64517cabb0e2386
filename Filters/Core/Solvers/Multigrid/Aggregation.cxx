// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Multigrid/Aggregation.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
namespace
{
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// A coupling is strong above this part of the mean of the two diagonal entries (Vanek, Mandel, Brezina
/// 1996); on each coarser level by the second factor less. Where triangles are stretched it keeps
/// couplings across the stretch out of the aggregates: along these sweeps do not smooth.
constexpr float StrongPart = 0.08f;
constexpr float StrongPartDecay = 0.7f;
/// The diagonal of the matrix without weak couplings is at least this part of the diagonal.
constexpr float LeastFilteredDiagonal = 0.3f;
/// All couplings of a vertex that sweeps solve for are no more than this part of the diagonal.
constexpr float FewCouplings = 0.9f;

/// Takes a value of the column's vertex to the row's.
CompactComplex Transport(const CompactComplex& mass)
{
  const float size = Modulus(mass);
  return size > 0.0f ? mass / size : CompactComplex(1.0f);
}

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
          const float bound =
            part * part * energy.Diagonal[i] * energy.Diagonal[energy.Column[k]];
          const bool strong = along < 0.0f && along * along > bound;
          couplings.Strength[k] = strong ? -along : 0.0f;
          lumped += strong ? 0.0f : along;
        }
        couplings.Diagonal[i] = std::max(lumped, LeastFilteredDiagonal * energy.Diagonal[i]);
      }
    });
  return couplings;
}

Aggregates Aggregate(
  const LevelMatrices& matrices, const Couplings& couplings, LeftOver leftOver)
{
  const CompactMatrix& energy = matrices.Energy;
  const Index n = energy.Rows();
  Aggregates aggregates{ LargeArray<Index>(n, None), LargeArray<CompactComplex>(n, 1.0f), 0 };
  // Whole neighbourhoods of strong couplings.
  for (Index root = 0; root < n; ++root)
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
  // The others join their strongest neighbour among those, or among the others before.
  const auto join = [&](Index v, const LargeArray<Index>& number)
  {
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
    if (best != None)
    {
      const Index neighbour = energy.Column[best];
      aggregates.Phase[v] = Transport(matrices.MassValue[best]) * aggregates.Phase[neighbour];
    }
    return best == None ? None : number[energy.Column[best]];
  };
  const LargeArray<Index> roots = aggregates.Number;
  std::vector<std::vector<Index>> left(NumberOfPieces(n, PieceRows));
  ParallelFor(n, PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (roots[v] == None)
        {
          aggregates.Number[v] = join(v, roots);
        }
        if (aggregates.Number[v] == None)
        {
          left[begin / PieceRows].push_back(v);
        }
      }
    });
  for (const std::vector<Index>& piece : left)
  {
    for (const Index v : piece)
    {
      aggregates.Number[v] = join(v, aggregates.Number);
      if (aggregates.Number[v] == None && !(leftOver == LeftOver::Drop && IsDominant(energy, v)))
      {
        aggregates.Number[v] = aggregates.Count++;
      }
    }
  }
  return aggregates;
}
}
