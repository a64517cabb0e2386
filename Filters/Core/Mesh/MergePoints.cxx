// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MergePoints.h"

#include <cmath>
#include <cstring>

namespace DirectionFields::Internal
{
namespace
{
/// The points entered so far, found by their coordinates.
class Places
{
public:
  Places(const std::vector<Vector3>& points, std::size_t count)
    : Points(points)
  {
    // At most half full, so that probing stays short.
    std::size_t size = 16;
    while (size < 2 * count)
    {
      size *= 2;
    }
    this->Slots.assign(size, None);
  }

  /// The point at the same place that was entered first; enters the point if there is none.
  Index Enter(Index point)
  {
    const Vector3& here = this->Points[point];
    std::size_t slot = this->Hash(here);
    for (;; slot = (slot + 1) & (this->Slots.size() - 1))
    {
      Index& entry = this->Slots[slot];
      if (entry == None)
      {
        return entry = point;
      }
      if (this->Points[entry] == here)
      {
        return entry;
      }
    }
  }

private:
  std::size_t Hash(const Vector3& point) const
  {
    std::uint64_t hash = 0;
    for (const double coordinate : point)
    {
      // -0 becomes 0.
      const double value = coordinate + 0.0;
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      // The finalizer of MurmurHash3: regular grids must not fall into few slots.
      hash ^= bits;
      hash ^= hash >> 33;
      hash *= 0xff51afd7ed558ccdULL;
      hash ^= hash >> 33;
      hash *= 0xc4ceb9fe1a85ec53ULL;
      hash ^= hash >> 33;
    }
    return static_cast<std::size_t>(hash) & (this->Slots.size() - 1);
  }

  const std::vector<Vector3>& Points;
  std::vector<Index> Slots;
};
}

std::vector<Index> FirstAtSamePlace(const Surface& surface)
{
  const auto size = static_cast<Index>(surface.Points.size());
  std::vector<char> used(size, 0);
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index point : triangle)
    {
      if (point >= 0 && point < size)
      {
        used[point] = 1;
      }
    }
  }
  Places places(surface.Points, surface.Points.size());
  std::vector<Index> first(size);
  for (Index i = 0; i < size; ++i)
  {
    first[i] = used[i] && surface.Points[i].allFinite() ? places.Enter(i) : i;
  }
  return first;
}

Surface Merged(const Surface& surface, const std::vector<Index>& first)
{
  Surface merged = surface;
  for (Triangle& triangle : merged.Triangles)
  {
    for (Index& point : triangle)
    {
      // Ids of no point are refused later, by name.
      if (point >= 0 && static_cast<std::size_t>(point) < first.size())
      {
        point = first[point];
      }
    }
  }
  return merged;
}

BoundaryPoints::BoundaryPoints(const TriangleMesh& mesh, const std::vector<Vector3>& points)
{
  // Several vertices may share a point.
  std::vector<char> seen(points.size(), 0);
  std::vector<Index> boundary;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    char& here = seen[mesh.Point(v)];
    if (mesh.IsBoundary(v) && !here)
    {
      here = 1;
      boundary.push_back(mesh.Point(v));
    }
  }
  this->Count = static_cast<Index>(boundary.size());
  Places places(points, boundary.size());
  std::vector<char> shared(points.size(), 0);
  for (const Index point : boundary)
  {
    const Index first = places.Enter(point);
    if (first != point)
    {
      this->Coincident += shared[first] ? 1 : 2;
      shared[first] = 1;
    }
  }
}
}
