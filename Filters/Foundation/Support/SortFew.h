// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SortFew_h
#define DirectionFields_SortFew_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace DirectionFields::Internal
{
/// Sorts items that are mostly a handful, like the edges of a vertex: insertion is fastest for few.
template <typename Item>
void SortFew(std::vector<Item>& items)
{
  constexpr std::size_t few = 32;
  if (items.size() > few)
  {
    std::sort(items.begin(), items.end());
    return;
  }
  for (std::size_t k = 1; k < items.size(); ++k)
  {
    const Item item = items[k];
    std::size_t at = k;
    for (; at > 0 && item < items[at - 1]; --at)
    {
      items[at] = items[at - 1];
    }
    items[at] = item;
  }
}
}

#endif
