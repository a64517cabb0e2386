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

/// The same with z before y before x: that is how the points of grids are numbered, of which it keeps the order.
inline bool LessAsInGrids(const Vector3& a, const Vector3& b)
{
  return LexicographicallyLess(a.reverse(), b.reverse());
}
}

#endif
