// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FacesAtEdges_h
#define DirectionFields_FacesAtEdges_h

#include "Types.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace Meshes
{
/// The number of faces at each edge of triangles, whose fourth corner is None, and quads. Ends are
/// ascending.
inline std::map<std::array<DirectionFields::Index, 2>, int> FacesAtEdges(
  const std::vector<std::array<DirectionFields::Index, 4>>& faces)
{
  std::map<std::array<DirectionFields::Index, 2>, int> count;
  for (const std::array<DirectionFields::Index, 4>& face : faces)
  {
    const int size = face[3] == DirectionFields::None ? 3 : 4;
    for (int c = 0; c < size; ++c)
    {
      const auto ends = std::minmax(face[c], face[(c + 1) % size]);
      ++count[{ ends.first, ends.second }];
    }
  }
  return count;
}
}

#endif
