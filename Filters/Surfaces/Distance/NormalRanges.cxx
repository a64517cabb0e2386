// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/NormalRanges.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cstdint>

namespace DirectionFields::Internal
{
NormalRanges::NormalRanges(const std::vector<Corners>& triangles, std::size_t levels)
  : Levels(levels)
{
  const auto count = static_cast<std::int64_t>(triangles.size());
  std::int64_t ofPart = Width;
  for (std::size_t level = 1; level < levels; ++level)
  {
    const std::int64_t ofNode = Width * ofPart;
    std::vector<Ranges>& nodes = this->Levels[level];
    nodes.resize(static_cast<std::size_t>((count + ofNode - 1) / ofNode));
    ParallelFor(static_cast<Index>(nodes.size()), LightPiece,
      [&](Index begin, Index end)
      {
        for (std::int64_t t = begin * ofNode; t < std::min(count, end * ofNode); ++t)
        {
          const std::int64_t part = t / ofPart;
          const Vector3 normal = NormalOf(triangles[t]);
          Ranges& node = nodes[part / Width];
          for (int axis = 0; axis < 3; ++axis)
          {
            double& least = node.Least[axis][part % Width];
            double& largest = node.Largest[axis][part % Width];
            least = std::min(least, normal[axis]);
            largest = std::max(largest, normal[axis]);
          }
        }
      });
    ofPart = ofNode;
  }
}
}
