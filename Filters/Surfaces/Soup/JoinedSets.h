// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_JoinedSets_h
#define DirectionFields_JoinedSets_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <algorithm>
#include <numeric>

namespace DirectionFields::Internal
{
/// Sets of the numbers 0 ... count - 1 that are joined, each named by its least member.
class JoinedSets
{
public:
  explicit JoinedSets(Index count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /// The least member of the set of a number.
  Index Find(Index k)
  {
    while (this->Parent[k] != k)
    {
      this->Parent[k] = this->Parent[this->Parent[k]];
      k = this->Parent[k];
    }
    return k;
  }

  void Join(Index a, Index b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  LargeArray<Index> Parent;
};
}

#endif
