// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RadixSort_h
#define DirectionFields_RadixSort_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <cstdint>

namespace DirectionFields
{
/// A number with the key that it is sorted by.
template <typename Key>
struct Keyed
{
  Key Value;
  Index Item;
};

/// Sorts by the keys; items of equal keys keep their order. Time is linear; the loops are shared
/// out among the threads. On one thread numbers of vertices (10 to 19 bits) take a seventh of the
/// time of std::sort, pairs of them (20 to 38 bits) and hashes of 32 bits a quarter, and keys of 63
/// bits, as along a Morton curve, half of it.
/// @param bits of the largest key; all higher ones are zero
void RadixSort(LargeArray<Keyed<std::uint32_t>>& items, int bits);
void RadixSort(LargeArray<Keyed<std::uint64_t>>& items, int bits);

/// How many bits the numbers below count have.
inline int BitsBelow(Index count)
{
  int bits = 0;
  while (bits < 31 && (std::int64_t(1) << bits) < count)
  {
    ++bits;
  }
  return bits;
}
}

#endif
