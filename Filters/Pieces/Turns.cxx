// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Turns.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>

namespace DirectionFields::Parallel
{
std::vector<int> TurnsOf(const std::vector<std::vector<int>>& members)
{
  const auto firstOf = [&](std::size_t task)
  { return members[task].empty() ? -1 : members[task].front(); };
  std::vector<std::size_t> order(members.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  // Intervals in the order of their beginnings need the fewest turns.
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return firstOf(a) < firstOf(b); });
  std::vector<int> turns(members.size(), 0);
  // The processes that are busy in each turn.
  std::vector<std::set<int>> busy;
  for (const std::size_t task : order)
  {
    const auto isFree = [&](const std::set<int>& others)
    {
      return std::none_of(members[task].begin(), members[task].end(),
        [&](int process) { return others.count(process) > 0; });
    };
    auto turn = std::find_if(busy.begin(), busy.end(), isFree);
    if (turn == busy.end())
    {
      turn = busy.emplace(busy.end());
    }
    turn->insert(members[task].begin(), members[task].end());
    turns[task] = static_cast<int>(turn - busy.begin());
  }
  return turns;
}
}
