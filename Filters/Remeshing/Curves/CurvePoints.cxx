// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurvePoints.h"

#include <algorithm>
#include <limits>

namespace DirectionFields::Internal
{
std::vector<Vector3> Apart(const std::vector<Vector3>& curve, double distance)
{
  std::vector<Vector3> apart;
  for (const Vector3& point : curve)
  {
    if (apart.empty() || !((point - apart.back()).norm() <= distance))
    {
      apart.push_back(point);
    }
  }
  if (apart.size() > 1)
  {
    apart.back() = curve.back();
  }
  return apart;
}

double RoomAt(const std::vector<Vector3>& curve, std::size_t i)
{
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t k = i > 0 ? i : 1; k < std::min(i + 2, curve.size()); ++k)
  {
    room = std::min(room, (curve[k] - curve[k - 1]).norm());
  }
  return room;
}
}
