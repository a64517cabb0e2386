// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ConeTree.h"

#include <algorithm>

namespace DirectionFields::Internal
{
std::vector<TreeCone> LeavesFirst(const CutMesh& mesh)
{
  const auto count = static_cast<Index>(mesh.Cones.size());
  // The cones at each jump: two, or one whose path ends at the boundary.
  std::vector<std::vector<Index>> conesAt(mesh.NumberOfJumps);
  for (Index k = 0; k < count; ++k)
  {
    for (const Jump& jump : mesh.Cones[k].Holonomy.Jumps)
    {
      std::vector<Index>& cones = conesAt[jump.Variable];
      if (cones.empty() || cones.back() != k)
      {
        cones.push_back(k);
      }
    }
  }
  std::vector<TreeCone> order;
  std::vector<char> isReached(count, 0);
  const auto reach = [&](Index cone, Index jump)
  {
    if (isReached[cone] == 0)
    {
      isReached[cone] = 1;
      order.push_back({ cone, jump });
    }
  };
  for (Index jump = 0; jump < mesh.NumberOfJumps; ++jump)
  {
    if (conesAt[jump].size() == 1)
    {
      reach(conesAt[jump].front(), jump);
    }
  }
  std::size_t done = 0;
  for (Index root = 0; root <= count; ++root)
  {
    for (; done < order.size(); ++done)
    {
      for (const Jump& jump : mesh.Cones[order[done].Cone].Holonomy.Jumps)
      {
        for (const Index other : conesAt[jump.Variable])
        {
          reach(other, jump.Variable);
        }
      }
    }
    if (root < count)
    {
      reach(root, None);
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}
}
