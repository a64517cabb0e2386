// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PointOrder_h
#define DirectionFields_PointOrder_h

#include "Types.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
/// The order of points that stands for numbers where results must not depend on numbering.
inline bool LexicographicallyLess(const Vector3& a, const Vector3& b)
{
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Whether the first of two points has the lower z, or else y, or else x, as the points of grids
/// are numbered. Coordinates that differ by less than a thousandth of the distance are equal up to
/// rounding. The relation is not transitive: it does not sort many points.
inline bool ComesFirstInGrids(const Vector3& a, const Vector3& b)
{
  const Vector3 step = b - a;
  const double rounding = 1e-3 * step.cwiseAbs().maxCoeff();
  const int axis = std::abs(step[2]) > rounding ? 2 : std::abs(step[1]) > rounding ? 1 : 0;
  return step[axis] > 0.0;
}
}

#endif
