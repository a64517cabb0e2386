// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Division_h
#define DirectionFields_Division_h

#include <algorithm>
#include <limits>

namespace DirectionFields::Internal
{
/// A quotient that stays within the range of double: larger quotients become the largest value.
inline double Divided(double value, double unit)
{
  constexpr double largest = std::numeric_limits<double>::max();
  return value == 0.0 ? 0.0 : std::clamp(value / unit, -largest, largest);
}

/// A value over the square of a unit, which stays within the range of double, too.
inline double PerSquare(double value, double unit)
{
  return Divided(Divided(value, unit), unit);
}
}

#endif
