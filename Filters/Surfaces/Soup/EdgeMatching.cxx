// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/EdgeMatching.h"

#include "Support/SortFew.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
Index Next(Index h)
{
  return h % 3 == 2 ? h - 2 : h + 1;
}

/// The corner of the triangle that a half-edge does not touch.
Index Opposite(const LargeArray<Index>& corners, Index h)
{
  return corners[Next(Next(h))];
}

/// The half-edge of a triangle that does not touch its least corner.
Index ThirdSide(const LargeArray<Index>& corners, Index t)
{
  const Index a = corners[3 * t];
  const Index b = corners[3 * t + 1];
  const Index c = corners[3 * t + 2];
  return 3 * t + (a < b ? (a < c ? 1 : 0) : (b < c ? 2 : 0));
}

/// A half-edge at the lower of its vertices.
struct Side
{
  Index Far;
  Index HalfEdge;
  bool operator<(const Side& other) const
  {
    return this->Far != other.Far ? this->Far < other.Far : this->HalfEdge < other.HalfEdge;
  }
};

/// Matches four half-edges of the same vertices so that each triangle has a neighbour of the
/// opposite direction that is not itself seen from behind. False where that does not say which.
bool MatchFour(const LargeArray<Index>& corners, const Side* sides, LargeArray<Index>& twins)
{
  std::array<Index, 4> halfEdges;
  std::transform(sides, sides + 4, halfEdges.begin(), [](const Side& s) { return s.HalfEdge; });
  const auto down = std::stable_partition(
    halfEdges.begin(), halfEdges.end(), [&](Index h) { return corners[h] < corners[Next(h)]; });
  if (down != halfEdges.begin() + 2)
  {
    return false;
  }
  const auto isFolded = [&](int up, int other)
  { return Opposite(corners, halfEdges[up]) == Opposite(corners, halfEdges[2 + other]); };
  const bool straight = isFolded(0, 0) || isFolded(1, 1);
  const bool crossed = isFolded(0, 1) || isFolded(1, 0);
  if (straight == crossed)
  {
    return false;
  }
  for (int k = 0; k < 2; ++k)
  {
    const Index g = halfEdges[k];
    const Index h = halfEdges[straight ? 3 - k : 2 + k];
    twins[g] = h;
    twins[h] = g;
  }
  return true;
}

/// Numbers from 0 on in groups: Members[Begin[k]] to Members[Begin[k + 1]], in ascending order.
struct Groups
{
  LargeArray<Index> Begin;
  LargeArray<Index> Members;
};

/// The third sides of the triangles at their lower vertices.
Groups GroupThirdSides(const LargeArray<Index>& corners, Index vertices)
{
  const auto triangles = static_cast<Index>(corners.size() / 3);
  const auto low = [&corners](Index h) { return std::min(corners[h], corners[Next(h)]); };
  // One place further than the group: filling moves the numbers back.
  Groups groups{ LargeArray<Index>(vertices + 2, 0), LargeArray<Index>(triangles) };
  for (Index t = 0; t < triangles; ++t)
  {
    ++groups.Begin[low(ThirdSide(corners, t)) + 2];
  }
  std::partial_sum(groups.Begin.begin(), groups.Begin.end(), groups.Begin.begin());
  for (Index t = 0; t < triangles; ++t)
  {
    const Index h = ThirdSide(corners, t);
    groups.Members[groups.Begin[low(h) + 1]++] = h;
  }
  return groups;
}

/// The number of the first triangle of each least corner.
LargeArray<Index> TrianglesOfLeastCorners(const LargeArray<Index>& corners, Index vertices)
{
  LargeArray<Index> begin(vertices + 1, 0);
  for (Index t = 0; 3 * t < static_cast<Index>(corners.size()); ++t)
  {
    ++begin[Opposite(corners, ThirdSide(corners, t)) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  return begin;
}
}

EdgeMatching::EdgeMatching(const LargeArray<Index>& corners, Index vertices)
  : Twins(corners.size())
{
  ParallelFor(static_cast<Index>(corners.size()), LightPiece,
    [&](Index begin, Index end)
    { std::fill(this->Twins.begin() + begin, this->Twins.begin() + end, None); });
  // Edges are matched at their lower vertices. Two sides of a triangle are found at its least
  // corner, by which the triangles are sorted; the third one is listed where it belongs.
  const LargeArray<Index> first = TrianglesOfLeastCorners(corners, vertices);
  const Groups third = GroupThirdSides(corners, vertices);
  std::vector<std::vector<Index>> nonManifold(NumberOfPieces(vertices, LightPiece));
  const auto counts = ParallelSum(vertices, LightPiece, Counts{},
    [&](Index begin, Index end)
    {
      Counts found;
      std::vector<Side> sides;
      for (Index v = begin; v < end; ++v)
      {
        sides.clear();
        for (Index t = first[v]; t < first[v + 1]; ++t)
        {
          const Index in = Next(ThirdSide(corners, t));
          sides.push_back({ corners[in], in });
          sides.push_back({ Opposite(corners, in), Next(in) });
        }
        for (Index k = third.Begin[v]; k < third.Begin[v + 1]; ++k)
        {
          const Index h = third.Members[k];
          sides.push_back({ std::max(corners[h], corners[Next(h)]), h });
        }
        SortFew(sides);
        for (std::size_t k = 0; k < sides.size();)
        {
          std::size_t next = k + 1;
          while (next < sides.size() && sides[next].Far == sides[k].Far)
          {
            ++next;
          }
          if (next - k == 2)
          {
            const Index g = sides[k].HalfEdge;
            const Index h = sides[k + 1].HalfEdge;
            this->Twins[g] = h;
            this->Twins[h] = g;
            found.Reversed += corners[g] == corners[h];
            found.Duplicate += Opposite(corners, g) == Opposite(corners, h);
          }
          else if (next - k == 4 && MatchFour(corners, &sides[k], this->Twins))
          {
            ++found.Shared;
          }
          else if (next - k > 2)
          {
            ++found.NonManifold;
            for (; k < next; ++k)
            {
              nonManifold[begin / LightPiece].push_back(sides[k].HalfEdge);
            }
          }
          k = next;
        }
      }
      return found;
    });
  this->Edges = counts;
  if (counts.NonManifold > 0 || counts.Shared > 0)
  {
    this->IsNonManifold.assign(corners.size(), 0);
    for (const std::vector<Index>& halfEdges : nonManifold)
    {
      for (const Index h : halfEdges)
      {
        this->IsNonManifold[h] = 1;
      }
    }
  }
}
}
