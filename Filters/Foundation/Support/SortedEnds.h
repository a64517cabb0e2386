// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SortedEnds_h
#define DirectionFields_SortedEnds_h

#include "Types.h"

#include <array>

namespace DirectionFields::Internal
{
/// The ends of an edge, the lower one first, by which it is found whatever its direction.
inline std::array<Index, 2> SortedEnds(Index a, Index b)
{
  return b < a ? std::array<Index, 2>{ b, a } : std::array<Index, 2>{ a, b };
}
}

#endif
