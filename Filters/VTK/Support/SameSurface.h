// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SameSurface_h
#define SameSurface_h

#include <DirectionFields/Surface.h>

#include <cstring>
#include <vector>

namespace DirectionFields
{
/// Whether two arrays have the same bytes. The values' own comparison would not do: unused points
/// may have NaN, which is never equal.
template <typename T>
bool SameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Whether two surfaces have the same points, triangles and ghosts, to the byte.
inline bool IsSameSurface(const Surface& a, const Surface& b)
{
  return SameBytes(a.Points, b.Points) && SameBytes(a.Triangles, b.Triangles) &&
    SameBytes(a.Ghost, b.Ghost);
}
}

#endif
