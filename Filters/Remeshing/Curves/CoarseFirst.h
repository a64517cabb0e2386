// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CoarseFirst_h
#define DirectionFields_CoarseFirst_h

#include <cstddef>
#include <vector>

namespace DirectionFields::Internal
{
/// Numbers from 0 to one less than a count: those that a high power of two divides first, then
/// those halfway between, and so on, each time from the lowest to the highest. Points of a row that
/// are put into triangles in this order have few triangles each, and lie close to the last one
/// (N. Amenta et al.: Incremental constructions con BRIO, 2003).
inline std::vector<std::size_t> CoarseFirst(std::size_t count)
{
  std::size_t step = 1;
  while (2 * step < count)
  {
    step *= 2;
  }
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < count; k += step)
  {
    order.push_back(k);
  }
  for (; step > 1; step /= 2)
  {
    for (std::size_t k = step / 2; k < count; k += step)
    {
      order.push_back(k);
    }
  }
  return order;
}
}

#endif
