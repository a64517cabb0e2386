// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/IntegerGrid.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
__extension__ using Wide = __int128;

/// Coordinates up to which the determinant of the circle fits into 128 bits.
constexpr std::int64_t CircleRange = std::int64_t(1) << 29;
}

int IntegerGrid::Orientation(const GridPoint& p, const GridPoint& q, const GridPoint& r)
{
  const GridPoint u = q - p;
  const GridPoint v = r - p;
  const double plus = static_cast<double>(u.A) * static_cast<double>(v.B);
  const double minus = static_cast<double>(u.B) * static_cast<double>(v.A);
  const double area = plus - minus;
  if (std::abs(area) > 1e-15 * (std::abs(plus) + std::abs(minus)))
  {
    return area > 0.0 ? 1 : -1;
  }
  const Wide exact = static_cast<Wide>(u.A) * v.B - static_cast<Wide>(u.B) * v.A;
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

bool IntegerGrid::IsInCircle(
  const GridPoint& p, const GridPoint& q, const GridPoint& r, const GridPoint& s) const
{
  const std::array<GridPoint, 3> edges = { p - s, q - s, r - s };
  std::int64_t largest = 0;
  for (const GridPoint& e : edges)
  {
    largest = std::max({ largest, std::abs(e.A), std::abs(e.B) });
  }
  if (largest >= CircleRange)
  {
    // No triangle that the mesh keeps is as large; the mesh is valid for any answer.
    return false;
  }
  std::array<Wide, 3> squares{};
  for (int k = 0; k < 3; ++k)
  {
    const Wide a = edges[k].A;
    const Wide b = edges[k].B;
    squares[k] = a * a + b * b + (this->Degree == 4 ? 0 : a * b);
  }
  Wide determinant = 0;
  for (int k = 0; k < 3; ++k)
  {
    const GridPoint& u = edges[(k + 1) % 3];
    const GridPoint& v = edges[(k + 2) % 3];
    determinant += squares[k] * (static_cast<Wide>(u.A) * v.B - static_cast<Wide>(u.B) * v.A);
  }
  return determinant > 0;
}
}
