// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PointOrder_h
#define DirectionFields_PointOrder_h

#include "Types.h"

#include <algorithm>

namespace DirectionFields::Internal
{
/// The order of points that stands for numbers where results must not depend on numbering.
inline bool LexicographicallyLess(const Vector3& a, const Vector3& b)
{
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}
}

#endif
