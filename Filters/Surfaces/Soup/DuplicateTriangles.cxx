// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/DuplicateTriangles.h"

#include "Soup/JoinedSets.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// The corners in ascending order, and whether they are wound like that.
struct Key
{
  Triangle Corners;
  bool IsAscending;
};

Key KeyOf(const Index* corners)
{
  Key key{ { corners[0], corners[1], corners[2] }, false };
  std::rotate(key.Corners.begin(), std::min_element(key.Corners.begin(), key.Corners.end()),
    key.Corners.end());
  key.IsAscending = key.Corners[1] < key.Corners[2];
  std::sort(key.Corners.begin(), key.Corners.end());
  return key;
}

/// Two triangles with the same corners and opposite windings.
using Pair = std::array<Index, 2>;

/// Marks triangles that are there twice in the same winding.
/// @return the pairs among the other triangles, by their first triangles
std::vector<Pair> MarkSameWinding(const LargeArray<Index>& corners, std::vector<char>& isDuplicate)
{
  const auto triangles = static_cast<Index>(corners.size() / 3);
  LargeArray<Key> keys(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    keys[t] = KeyOf(corners.data() + 3 * static_cast<std::size_t>(t));
  }
  LargeArray<Index> order(triangles);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&keys](Index a, Index b)
    { return keys[a].Corners != keys[b].Corners ? keys[a].Corners < keys[b].Corners : a < b; });
  std::vector<Pair> pairs;
  for (Index k = 0; k < triangles;)
  {
    const Key& key = keys[order[k]];
    Pair first = { None, None };
    for (; k < triangles && keys[order[k]].Corners == key.Corners; ++k)
    {
      Index& of = first[keys[order[k]].IsAscending ? 1 : 0];
      isDuplicate[order[k]] = of != None;
      of = of == None ? order[k] : of;
    }
    if (first[0] != None && first[1] != None)
    {
      pairs.push_back({ std::min(first[0], first[1]), std::max(first[0], first[1]) });
    }
  }
  return pairs;
}

/// A side of a triangle, from the lower to the higher of its vertices.
struct Side
{
  Index Low;
  Index High;
  /// Of the triangle; None if it is in none.
  Index Pair;
  bool RunsUp;

  bool IsAlong(const Side& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const Side& other) const
  {
    return this->Low != other.Low ? this->Low < other.Low
      : this->High != other.High  ? this->High < other.High
                                  : this->Pair < other.Pair;
  }
};

/// All sides along which there are pairs, in order, and possibly others.
std::vector<Side> SidesAtPairs(const LargeArray<Index>& corners,
  const std::vector<char>& isDuplicate, const std::vector<Pair>& pairs)
{
  const auto triangles = static_cast<Index>(corners.size() / 3);
  LargeArray<Index> pairOf(triangles, None);
  std::vector<char> isAtPair(
    static_cast<std::size_t>(*std::max_element(corners.begin(), corners.end())) + 1, 0);
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    for (const Index t : pairs[p])
    {
      pairOf[t] = static_cast<Index>(p);
    }
    for (int c = 0; c < 3; ++c)
    {
      isAtPair[corners[3 * pairs[p][0] + c]] = 1;
    }
  }
  std::vector<Side> sides;
  for (Index t = 0; t < triangles; ++t)
  {
    for (int c = 0; c < 3 && !isDuplicate[t]; ++c)
    {
      const Index from = corners[3 * t + c];
      const Index to = corners[3 * t + (c + 1) % 3];
      if (isAtPair[from] && isAtPair[to])
      {
        sides.push_back({ std::min(from, to), std::max(from, to), pairOf[t], from < to });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// The vote of the sides along one edge on the pairs there: 1 if both triangles go on, -1 if one of
/// them is enough, 0 if they say nothing.
/// @param inPairs, others the number of these sides; up of the others run from the lower vertex to
///                        the higher one
int Vote(std::size_t inPairs, std::size_t others, std::size_t up)
{
  if (others == 0 && inPairs <= 4)
  {
    return 0;
  }
  return inPairs == 2 && others == 2 && up == 1 ? 1 : -1;
}
}

std::vector<char> FindDuplicateTriangles(const LargeArray<Index>& corners)
{
  std::vector<char> isDuplicate(corners.size() / 3, 0);
  const std::vector<Pair> pairs = MarkSameWinding(corners, isDuplicate);
  if (pairs.empty())
  {
    return isDuplicate;
  }
  const std::vector<Side> sides = SidesAtPairs(corners, isDuplicate, pairs);
  const auto number = static_cast<Index>(pairs.size());
  JoinedSets sets(number);
  std::vector<Index> votes(pairs.size(), 0);
  for (std::size_t k = 0; k < sides.size();)
  {
    // Sides that are in no pair come first.
    const std::size_t begin = k;
    std::size_t up = 0;
    for (; k < sides.size() && sides[k].IsAlong(sides[begin]) && sides[k].Pair == None; ++k)
    {
      up += sides[k].RunsUp;
    }
    const std::size_t paired = k;
    while (k < sides.size() && sides[k].IsAlong(sides[begin]))
    {
      ++k;
    }
    const int vote = Vote(k - paired, paired - begin, up);
    for (std::size_t j = paired; j < k; j += 2)
    {
      votes[sides[j].Pair] += vote;
      sets.Join(sides[paired].Pair, sides[j].Pair);
    }
  }
  std::vector<Index> sum(pairs.size(), 0);
  for (Index p = 0; p < number; ++p)
  {
    sum[sets.Find(p)] += votes[p];
  }
  for (Index p = 0; p < number; ++p)
  {
    isDuplicate[pairs[p][1]] = sum[sets.Find(p)] <= 0;
  }
  return isDuplicate;
}
}
