// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/LargeArray.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

using namespace DirectionFields;

TEST(LargeArray, KeepsItsValuesWhereItGrows)
{
  LargeArray<int> array(3, 7);
  for (const std::size_t size : { std::size_t(10), std::size_t(1) << 20, std::size_t(3) << 20 })
  {
    const std::size_t old = array.size();
    array.resize(size);
    std::iota(array.begin() + static_cast<std::ptrdiff_t>(old), array.end(), static_cast<int>(old));
  }
  for (std::size_t k = 0; k < array.size(); ++k)
  {
    ASSERT_EQ(array[k], k < 3 ? 7 : static_cast<int>(k));
  }
  const LargeArray<int> copy = array;
  EXPECT_EQ(copy, array);
}

TEST(LargeArray, StorageIsAlignedForEveryType)
{
  for (const std::size_t bytes : { std::size_t(0), std::size_t(1), std::size_t(5) << 20 })
  {
    void* const storage = AllocateLarge(bytes);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(storage) % alignof(std::max_align_t), 0u);
    ReleaseLarge(storage);
  }
}

TEST(LargeArray, AdviceLeavesValuesAlone)
{
  std::vector<int> values((std::size_t(5) << 20) + 3);
  std::iota(values.begin(), values.end(), 0);
  const std::vector<int> before = values;
  // From any place on, for any length.
  PreferLargePages(values.data() + 1, (values.size() - 1) * sizeof(int));
  PreferLargePages(values.data() + 1, 5);
  EXPECT_EQ(values, before);
}

TEST(LargeArray, MoreThanCanBeAddressedIsABadAllocation)
{
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max() / sizeof(double);
  LargeArrayAllocator<double> allocator;
  EXPECT_THROW(allocator.allocate(most + 1), std::bad_alloc);
  EXPECT_THROW(allocator.allocate(2 * most), std::bad_alloc);
}
