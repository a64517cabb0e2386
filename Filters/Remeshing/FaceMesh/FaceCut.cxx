// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/FaceCut.h"

#include <algorithm>

namespace DirectionFields::Internal
{
FaceParts CutAtEdge(const std::vector<Vector3>& points, const Faces::Face& face,
  const std::array<Index, 2>& ends, const Vector3& place)
{
  const auto fresh = static_cast<Index>(points.size());
  const int size = Faces::Size(face);
  const auto isEdge = [&](int c)
  {
    const Index v = face[c];
    const Index w = face[(c + 1) % size];
    return std::min(v, w) == ends[0] && std::max(v, w) == ends[1];
  };
  int at = 0;
  while (!isEdge(at))
  {
    ++at;
  }
  const Index tail = face[at];
  const Index head = face[(at + 1) % size];
  const Index afterHead = face[(at + 2) % size];
  const Index beforeTail = face[(at + size - 1) % size];
  const auto quality = [&](const Faces::Face& part)
  {
    std::vector<Vector3> corners;
    Faces::Face own = { None, None, None, None };
    for (int c = 0; c < Faces::Size(part); ++c)
    {
      corners.push_back(part[c] == fresh ? place : points[part[c]]);
      own[c] = c;
    }
    return ScaledJacobian(corners, own);
  };
  const auto parts = [&](const Faces::Face& first, const Faces::Face& second) {
    return FaceParts{ first, second, std::min(quality(first), quality(second)) };
  };
  if (size == 3)
  {
    return parts({ fresh, head, afterHead, None }, { tail, fresh, afterHead, None });
  }
  const FaceParts one =
    parts({ fresh, head, afterHead, None }, { tail, fresh, afterHead, beforeTail });
  const FaceParts other =
    parts({ tail, fresh, beforeTail, None }, { fresh, head, afterHead, beforeTail });
  return other.Quality > one.Quality ? other : one;
}
}
