// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NormalRanges_h
#define DirectionFields_NormalRanges_h

#include "Types.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace DirectionFields::Internal
{
/// The ranges of the normals of the triangles in the four parts of each node of a tree, without
/// which a search for the other side of a plane or a fan looks at all triangles within the
/// distance.
class NormalRanges
{
public:
  static constexpr Index Width = 4;
  using Numbers = Eigen::Array<double, Width, 1>;
  using Corners = std::array<Vector3, 3>;

  static Vector3 NormalOf(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

  /// Node k of level l has the triangles from 4^(l + 1) k on. There are none of level 0, whose
  /// parts are triangles.
  NormalRanges(const std::vector<Corners>& triangles, std::size_t levels);

  /// At least the products of the triangles' normals with a normal, of the parts of a node: sums of
  /// the same order are rounded the same way.
  Numbers LargestProducts(std::size_t level, Index node, const Vector3& normal) const
  {
    const Ranges& ranges = this->Levels[level][node];
    const auto largest = [&](int axis)
    { return (normal[axis] * ranges.Least[axis]).max(normal[axis] * ranges.Largest[axis]); };
    return largest(0) + largest(1) + largest(2);
  }

private:
  struct Ranges
  {
    static std::array<Numbers, 3> Filled(double value)
    {
      const Numbers numbers = Numbers::Constant(value);
      return { numbers, numbers, numbers };
    }
    std::array<Numbers, 3> Least = Filled(std::numeric_limits<double>::infinity());
    std::array<Numbers, 3> Largest = Filled(-std::numeric_limits<double>::infinity());
  };
  std::vector<std::vector<Ranges>> Levels;
};
}

#endif
