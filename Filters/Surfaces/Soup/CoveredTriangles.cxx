// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/CoveredTriangles.h"

#include <stdexcept>

namespace DirectionFields::Internal
{
CoveredTriangles::CoveredTriangles(
  const std::vector<char>& isCovered, LargeArray<Index>& corners, LargeArray<Index>& twins)
{
  const auto triangles = static_cast<Index>(isCovered.size());
  this->Mirrors.assign(triangles, None);
  for (Index t = 0; t < triangles; ++t)
  {
    if (isCovered[t])
    {
      this->Mirrors[t] = static_cast<Index>(this->Mirrors.size());
      this->Mirrors.push_back(t);
      if (this->Mirrors.size() > std::numeric_limits<Index>::max() / 3)
      {
        throw std::length_error(
          "The two sides of a surface that cannot be oriented have more "
          "triangles than can be numbered. Decimate it or process it in parts.");
      }
      const Triangle other = { corners[3 * t], corners[3 * t + 2], corners[3 * t + 1] };
      corners.insert(corners.end(), other.begin(), other.end());
    }
  }
  this->IsBack.assign(this->Mirrors.size(), 0);
  std::fill(this->IsBack.begin() + triangles, this->IsBack.end(), 1);

  twins.resize(corners.size(), None);
  const auto mirror = [this](Index h) { return 3 * this->Mirrors[h / 3] + 2 - h % 3; };
  const auto join = [&twins](Index g, Index h)
  {
    twins[g] = h;
    twins[h] = g;
  };
  for (Index h = 0; h < 3 * triangles; ++h)
  {
    const Index twin = twins[h];
    // Pairs that lead to the other side are done, too.
    if (this->Mirrors[h / 3] == None || twin < h || twin >= 3 * triangles)
    {
      continue;
    }
    if (corners[h] != corners[twin])
    {
      join(mirror(h), mirror(twin));
    }
    else
    {
      join(h, mirror(twin));
      join(mirror(h), twin);
    }
  }
}
}
