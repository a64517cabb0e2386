// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/RadixSort.h"

#include "Support/Threads.h"

namespace DirectionFields
{
namespace
{
constexpr Index SortPiece = 1 << 15;
/// Fewer items take digits of fewer bits: the counters should be no more than the items.
constexpr Index FewItems = 1 << 13;

template <typename Key>
void Sort(LargeArray<Keyed<Key>>& items, int bits)
{
  const auto count = static_cast<Index>(items.size());
  const int widest = count < FewItems ? 8 : 12;
  const int passes = (bits + widest - 1) / widest;
  if (count < 2 || passes == 0)
  {
    return;
  }
  const int width = (bits + passes - 1) / passes;
  const Index buckets = 1 << width;
  const Index pieces = NumberOfPieces(count, SortPiece);
  LargeArray<Index> next(static_cast<std::size_t>(pieces) * buckets);
  LargeArray<Keyed<Key>> sorted(items.size());
  for (int shift = 0; shift < bits; shift += width)
  {
    const auto digit = [shift, buckets](const Keyed<Key>& item)
    { return static_cast<Index>((item.Value >> shift) & static_cast<Key>(buckets - 1)); };
    const auto counters = [&](Index begin)
    { return next.data() + static_cast<std::size_t>(begin / SortPiece) * buckets; };
    ParallelFor(count, SortPiece,
      [&](Index begin, Index end)
      {
        Index* const counter = counters(begin);
        std::fill(counter, counter + buckets, 0);
        for (Index k = begin; k < end; ++k)
        {
          ++counter[digit(items[k])];
        }
      });
    // The place where each piece puts its items of each digit.
    Index at = 0;
    for (Index bucket = 0; bucket < buckets; ++bucket)
    {
      for (Index piece = 0; piece < pieces; ++piece)
      {
        Index& counter = next[static_cast<std::size_t>(piece) * buckets + bucket];
        const Index here = counter;
        counter = at;
        at += here;
      }
    }
    ParallelFor(count, SortPiece,
      [&](Index begin, Index end)
      {
        Index* const counter = counters(begin);
        for (Index k = begin; k < end; ++k)
        {
          sorted[counter[digit(items[k])]++] = items[k];
        }
      });
    items.swap(sorted);
  }
}
}

void RadixSort(LargeArray<Keyed<std::uint32_t>>& items, int bits)
{
  Sort(items, bits);
}

void RadixSort(LargeArray<Keyed<std::uint64_t>>& items, int bits)
{
  Sort(items, bits);
}
}
