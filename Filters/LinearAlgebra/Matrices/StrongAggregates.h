// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StrongAggregates_h
#define DirectionFields_StrongAggregates_h

#include "Support/LargeArray.h"
#include "Support/Threads.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The rows of a sparse matrix with the strength of each entry: 0 where the coupling is weak.
struct StrengthRows
{
  Index Rows;
  const Index* Begin;
  const Index* Column;
  const float* Strength;
};

/// Makes an aggregate of each row with strong couplings, none of which leads to an aggregate so
/// far: the row is the root, its neighbours by strong couplings belong to it.
/// @param number None for all rows
/// @return the number of aggregates
template <typename JoinsRoot>
Index AggregateNeighbourhoods(
  const StrengthRows& matrix, LargeArray<Index>& number, const JoinsRoot& joinsRoot)
{
  Index count = 0;
  for (Index root = 0; root < matrix.Rows; ++root)
  {
    bool isFree = number[root] == None;
    bool isCoupled = false;
    for (Index k = matrix.Begin[root]; isFree && k < matrix.Begin[root + 1]; ++k)
    {
      isCoupled = isCoupled || matrix.Strength[k] > 0.0F;
      isFree = matrix.Strength[k] == 0.0F || number[matrix.Column[k]] == None;
    }
    if (!isFree || !isCoupled)
    {
      continue;
    }
    number[root] = count;
    for (Index k = matrix.Begin[root]; k < matrix.Begin[root + 1]; ++k)
    {
      if (matrix.Strength[k] > 0.0F)
      {
        number[matrix.Column[k]] = count;
        joinsRoot(k);
      }
    }
    ++count;
  }
  return count;
}

/// Aggregates of smoothed aggregation (P. Vaněk, J. Mandel, M. Brezina, Computing 56, 1996): whole
/// neighbourhoods of strong couplings, first come, first served; the rows between them join the
/// aggregate of their strongest neighbour, first only neighbourhoods, so that aggregates do not
/// grow in lines. The same for any number of threads, with which joinsRoot and joins must be safe
/// for different rows.
/// @param number    becomes the aggregate of each row; None where it was left out
/// @param joinsRoot called with entry k of a root's row, whose column belongs to the root's
///                  neighbourhood
/// @param joins     called with a row and that entry k of it whose column's aggregate the row joins
/// @param stays     whether a row without a strong neighbour becomes an aggregate of its own
/// @return the number of aggregates
template <typename JoinsRoot, typename Joins, typename Stays>
Index AggregateStrongly(const StrengthRows& matrix, LargeArray<Index>& number,
  const JoinsRoot& joinsRoot, const Joins& joins, const Stays& stays)
{
  constexpr Index pieceRows = 4096;
  number = LargeArray<Index>(matrix.Rows, None);
  Index count = AggregateNeighbourhoods(matrix, number, joinsRoot);
  const auto joined = [&](Index row, const LargeArray<Index>& of)
  {
    Index best = None;
    float strongest = 0.0F;
    for (Index k = matrix.Begin[row]; k < matrix.Begin[row + 1]; ++k)
    {
      if (matrix.Strength[k] > strongest && of[matrix.Column[k]] != None)
      {
        strongest = matrix.Strength[k];
        best = k;
      }
    }
    if (best == None)
    {
      return None;
    }
    joins(row, best);
    return of[matrix.Column[best]];
  };
  // Rows next to a neighbourhood join it, on several threads: the neighbourhoods do not change.
  const LargeArray<Index> neighbourhoods = number;
  std::vector<std::vector<Index>> remaining(NumberOfPieces(matrix.Rows, pieceRows));
  ParallelFor(matrix.Rows, pieceRows,
    [&](Index begin, Index end)
    {
      for (Index row = begin; row < end; ++row)
      {
        if (neighbourhoods[row] == None)
        {
          number[row] = joined(row, neighbourhoods);
          if (number[row] == None)
          {
            remaining[begin / pieceRows].push_back(row);
          }
        }
      }
    });
  for (const std::vector<Index>& piece : remaining)
  {
    for (const Index row : piece)
    {
      number[row] = joined(row, number);
      if (number[row] == None && stays(row))
      {
        number[row] = count++;
      }
    }
  }
  return count;
}
}

#endif
