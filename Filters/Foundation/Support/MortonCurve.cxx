// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/MortonCurve.h"

#include "Support/RadixSort.h"
#include "Support/Threads.h"

namespace DirectionFields::Internal
{
namespace
{
/// The bits of a number below 2^21 with two zeros before each.
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffu;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffu;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fu;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

LargeArray<Index> Items(const LargeArray<Keyed<std::uint64_t>>& order)
{
  LargeArray<Index> items(order.size());
  ParallelFor(static_cast<Index>(order.size()), LightPiece,
    [&](Index begin, Index end)
    {
      std::transform(order.begin() + begin, order.begin() + end, items.begin() + begin,
        [](const Keyed<std::uint64_t>& keyed) { return keyed.Item; });
    });
  return items;
}
}

// Halved: the difference of the largest coordinates would overflow.
MortonCurve::MortonCurve(const BoundingBox& box)
  : HalfLow(0.5 * box.Low)
  , HalfSize((0.5 * box.High - 0.5 * box.Low).maxCoeff())
{
}

std::uint64_t MortonCurve::Place(const Vector3& point) const
{
  constexpr double cells = 1 << (Bits / 3);
  if (!(this->HalfSize > 0.0))
  {
    return 0;
  }
  std::uint64_t place = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double part = (0.5 * point[axis] - this->HalfLow[axis]) / this->HalfSize;
    place |= Spread(static_cast<std::uint64_t>(std::min(part * cells, cells - 1.0))) << axis;
  }
  return place;
}

LargeArray<Index> MortonCurve::Sorted(
  const std::vector<Vector3>& points, const LargeArray<Index>& members)
{
  const auto count = static_cast<Index>(members.size());
  const MortonCurve curve(ParallelSum(count, LightPiece, BoundingBox{},
    [&](Index begin, Index end)
    {
      BoundingBox box;
      for (Index k = begin; k < end; ++k)
      {
        box.Add(points[members[k]]);
      }
      return box;
    }));
  LargeArray<Keyed<std::uint64_t>> order(members.size());
  ParallelFor(count, LightPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        order[k] = { curve.Place(points[members[k]]), members[k] };
      }
    });
  RadixSort(order, Bits);
  return Items(order);
}

LargeArray<Index> MortonCurve::SortedInGroups(const std::vector<Vector3>& points,
  const LargeArray<Index>& members, const LargeArray<Index>& group, Index groups)
{
  const auto count = static_cast<Index>(members.size());
  std::vector<BoundingBox> boxes(groups);
  LargeArray<Keyed<std::uint64_t>> order(count);
  for (Index k = 0; k < count; ++k)
  {
    boxes[group[k]].Add(points[members[k]]);
    order[k] = { static_cast<std::uint64_t>(members[k]), k };
  }
  RadixSort(order, BitsBelow(static_cast<Index>(points.size())));
  const std::vector<MortonCurve> curves(boxes.begin(), boxes.end());
  ParallelFor(count, LightPiece,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        const Index member = order[k].Item;
        order[k].Value = curves[group[member]].Place(points[members[member]]);
      }
    });
  RadixSort(order, Bits);
  for (Keyed<std::uint64_t>& member : order)
  {
    member.Value = static_cast<std::uint64_t>(group[member.Item]);
  }
  RadixSort(order, BitsBelow(groups));
  return Items(order);
}
}
