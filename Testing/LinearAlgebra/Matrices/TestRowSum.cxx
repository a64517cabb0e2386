// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/RowSum.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace DirectionFields;

namespace
{
/// @param stride of the columns: those that differ by a power of two share storage
void ExpectSums(RowSum<double>& sum, int columns, Index stride, bool sorted)
{
  std::mt19937 engine(columns);
  std::map<Index, double> expected;
  for (int k = 0; k < 3 * columns; ++k)
  {
    const Index column = stride * static_cast<Index>(engine() % columns);
    expected[column] += k + 1.0;
    sum[column] += k + 1.0;
  }
  std::map<Index, double> sums;
  const auto take = [&](auto first, auto last)
  {
    Index before = -1;
    for (; first != last; ++first)
    {
      if (sorted)
      {
        EXPECT_GT(first->first, before);
        before = first->first;
      }
      sums[first->first] += first->second;
    }
  };
  sorted ? sum.TakeSorted(take) : sum.Take(take);
  EXPECT_EQ(sums, expected);
}
}

TEST(RowSum, AddsUpWhateverTheColumns)
{
  RowSum<double> sum;
  // One after the other: nothing of a row is left in the next one.
  for (const int columns : { 1, 7, 200, 3000, 5 })
  {
    for (const Index stride : { 1, 3, 64, 1024, 4096 })
    {
      ExpectSums(sum, columns, stride, true);
      ExpectSums(sum, columns, stride, false);
    }
  }
  const auto expectNone = [](auto first, auto last) { EXPECT_TRUE(first == last); };
  sum.TakeSorted(expectNone);
  sum.Take(expectNone);
}
