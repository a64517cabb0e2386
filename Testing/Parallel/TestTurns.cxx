// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

using DirectionFields::Parallel::TurnsOf;

namespace
{
/// How many tasks the busiest process has.
int MostOfOne(const std::vector<std::vector<int>>& members)
{
  std::vector<int> count(16, 0);
  for (const std::vector<int>& processes : members)
  {
    for (const int process : processes)
    {
      ++count[process];
    }
  }
  return *std::max_element(count.begin(), count.end());
}

int CountTurns(const std::vector<int>& turns)
{
  return turns.empty() ? 0 : 1 + *std::max_element(turns.begin(), turns.end());
}

/// Whether no process has two tasks in one turn.
bool AreApart(const std::vector<std::vector<int>>& members, const std::vector<int>& turns)
{
  std::set<std::pair<int, int>> seen;
  for (std::size_t task = 0; task < members.size(); ++task)
  {
    for (const int process : members[task])
    {
      if (!seen.emplace(turns[task], process).second)
      {
        return false;
      }
    }
  }
  return true;
}
}

TEST(Turns, OfTasksWithoutCommonProcessesIsTheFirst)
{
  EXPECT_EQ(TurnsOf({ { 0, 1 }, { 2, 3 }, { 4 } }), std::vector<int>({ 0, 0, 0 }));
  EXPECT_TRUE(TurnsOf({}).empty());
  EXPECT_EQ(TurnsOf({ {}, { 0 } }), std::vector<int>({ 0, 0 }));
}

TEST(Turns, AreAsFewAsTheBusiestProcessHasTasksWhereTheyAreSlabs)
{
  // A chain, which would take one turn after another in the order of its links.
  EXPECT_EQ(TurnsOf({ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 } }), std::vector<int>({ 0, 1, 0, 1 }));
  std::minstd_rand random(7);
  for (int repeat = 0; repeat < 200; ++repeat)
  {
    std::vector<std::vector<int>> members(1 + random() % 12);
    for (std::vector<int>& processes : members)
    {
      const int first = static_cast<int>(random() % 12);
      for (int p = first; p <= first + static_cast<int>(random() % 4); ++p)
      {
        processes.push_back(p);
      }
    }
    const std::vector<int> turns = TurnsOf(members);
    EXPECT_TRUE(AreApart(members, turns));
    EXPECT_EQ(CountTurns(turns), MostOfOne(members));
  }
}

TEST(Turns, KeepTasksOfAnyProcessesApart)
{
  std::minstd_rand random(3);
  for (int repeat = 0; repeat < 200; ++repeat)
  {
    std::vector<std::vector<int>> members(1 + random() % 10);
    for (std::vector<int>& processes : members)
    {
      for (int p = 0; p < 8; ++p)
      {
        if (random() % 3 == 0)
        {
          processes.push_back(p);
        }
      }
    }
    EXPECT_TRUE(AreApart(members, TurnsOf(members)));
  }
}
