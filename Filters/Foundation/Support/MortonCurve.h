// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MortonCurve_h
#define DirectionFields_MortonCurve_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace DirectionFields::Internal
{
/// The box around finite points; empty without any.
struct BoundingBox
{
  Vector3 Low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 High = Vector3::Constant(-std::numeric_limits<double>::infinity());

  void Add(const Vector3& point)
  {
    this->Low = this->Low.cwiseMin(point);
    this->High = this->High.cwiseMax(point);
  }
  void operator+=(const BoundingBox& other)
  {
    this->Low = this->Low.cwiseMin(other.Low);
    this->High = this->High.cwiseMax(other.High);
  }
};

/// A Morton curve (Z-order) through the cube around a box: points that are close in space are
/// mostly close along it.
class MortonCurve
{
public:
  /// The bits of a place along the curve. Points within a millionth of the cube may have the same.
  static constexpr int Bits = 60;

  explicit MortonCurve(const BoundingBox& box);
  std::uint64_t Place(const Vector3& point) const;

  /// Points in the order of a curve; points at the same place keep their order.
  /// @param members ids of finite points
  static LargeArray<Index> Sorted(
    const std::vector<Vector3>& points, const LargeArray<Index>& members);

  /// Positions of points in the order of their groups, within a group in that of a curve of its
  /// own, and at the same place of it in that of their ids.
  /// @param members  ids of finite points
  /// @param group    of each of them, 0 to groups - 1
  static LargeArray<Index> SortedInGroups(const std::vector<Vector3>& points,
    const LargeArray<Index>& members, const LargeArray<Index>& group, Index groups);

private:
  Vector3 HalfLow;
  double HalfSize;
};
}

#endif
