// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MergePoints.h"

#include "Support/LargeArray.h"
#include "Support/RadixSort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

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

/// Sets of points that grow together; the first point of each stands for it.
class PointSets
{
public:
  PointSets() = default;
  explicit PointSets(std::size_t points)
    : Parent(points)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  Index First(Index point)
  {
    while (this->Parent[point] != point)
    {
      point = this->Parent[point] = this->Parent[this->Parent[point]];
    }
    return point;
  }
  void Unite(Index a, Index b)
  {
    const auto [first, second] = std::minmax({ this->First(a), this->First(b) });
    this->Parent[second] = first;
  }

private:
  std::vector<Index> Parent;
};

/// The points of a triangle of the mesh.
std::array<Index, 3> CornersOf(const TriangleMesh& mesh, Index triangle)
{
  return { mesh.Point(mesh.Tail(3 * triangle)), mesh.Point(mesh.Tail(3 * triangle + 1)),
    mesh.Point(mesh.Tail(3 * triangle + 2)) };
}

/// The edges of the boundary, and the points that become one across pairs of them.
class Seams
{
public:
  Seams(const TriangleMesh& mesh, const std::vector<Vector3>& points)
    : Mesh(mesh)
    , Points(points)
  {
    std::size_t edges = 0;
    this->ForBoundary([&edges](Index) { ++edges; });
    this->Place.assign(edges > 0 ? points.size() : 0, None);
    Places places(points, 2 * edges);
    this->ForBoundary(
      [&](Index h)
      {
        for (const Index v : { mesh.Tail(h), mesh.Head(h) })
        {
          Index& place = this->Place[mesh.Point(v)];
          place = place == None ? places.Enter(mesh.Point(v)) : place;
          this->AnyShared = this->AnyShared || place != mesh.Point(v);
        }
      });
  }

  /// Whether several points of the boundary are at the same place.
  bool MayExist() const { return this->AnyShared; }

  std::vector<Index> Join()
  {
    this->Sets = PointSets(this->Points.size());
    LargeArray<Keyed<std::uint64_t>> edges;
    const int bits = BitsBelow(static_cast<Index>(this->Points.size()));
    this->ForBoundary(
      [&](Index h)
      {
        const auto [low, high] =
          std::minmax({ this->PlaceOf(this->Mesh.Tail(h)), this->PlaceOf(this->Mesh.Head(h)) });
        if (this->Collapses(h / 3))
        {
          return;
        }
        if (low == high)
        {
          this->Sets.Unite(
            this->Mesh.Point(this->Mesh.Tail(h)), this->Mesh.Point(this->Mesh.Head(h)));
        }
        else
        {
          edges.push_back(
            { static_cast<std::uint64_t>(low) << bits | static_cast<unsigned>(high), h });
        }
      });
    RadixSort(edges, 2 * bits);
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
    {
      while (end < edges.size() && edges[end].Value == edges[begin].Value)
      {
        ++end;
      }
      if (end - begin == 2)
      {
        this->JoinEdges(edges[begin].Item, edges[begin + 1].Item);
      }
    }
    std::vector<Index> first(this->Points.size());
    bool any = false;
    for (Index i = 0; i < static_cast<Index>(first.size()); ++i)
    {
      first[i] = this->Sets.First(i);
      any = any || first[i] != i;
    }
    return any ? first : std::vector<Index>{};
  }

private:
  /// Calls body(h) for each half-edge of the boundary, once where covers have it twice.
  template <typename Body>
  void ForBoundary(const Body& body) const
  {
    for (const TriangleMesh::Component& component : this->Mesh.GetComponents())
    {
      for (Index h = 3 * component.FirstTriangle;
           !component.Closed && h < 3 * component.EndTriangle; ++h)
      {
        if (this->Mesh.Twin(h) == None && this->Mesh.IsFront(h / 3))
        {
          body(h);
        }
      }
    }
  }

  Index PlaceOf(Index vertex) const { return this->Place[this->Mesh.Point(vertex)]; }

  /// Makes the corners at the same place of a triangle one where nothing is connected with it.
  /// Returns whether there are any.
  bool Collapses(Index triangle)
  {
    const std::array<Index, 3> corners = CornersOf(this->Mesh, triangle);
    bool collapses = false;
    for (int c = 0; c < 3; ++c)
    {
      if (this->Mesh.Twin(3 * triangle + c) != None)
      {
        return false;
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      const Index a = corners[c];
      const Index b = corners[(c + 1) % 3];
      if (this->Place[a] == this->Place[b])
      {
        this->Sets.Unite(a, b);
        collapses = true;
      }
    }
    return collapses;
  }

  void JoinEdges(Index h, Index g)
  {
    const Index third = this->Mesh.Point(this->Mesh.Tail(TriangleMesh::Previous(h)));
    const Index other = this->Mesh.Point(this->Mesh.Tail(TriangleMesh::Previous(g)));
    if (h / 3 == g / 3 || this->Points[third] == this->Points[other])
    {
      return;
    }
    Index from = this->Mesh.Tail(g);
    Index to = this->Mesh.Head(g);
    if (this->PlaceOf(this->Mesh.Tail(h)) != this->PlaceOf(from))
    {
      std::swap(from, to);
    }
    this->Sets.Unite(this->Mesh.Point(this->Mesh.Tail(h)), this->Mesh.Point(from));
    this->Sets.Unite(this->Mesh.Point(this->Mesh.Head(h)), this->Mesh.Point(to));
  }

  const TriangleMesh& Mesh;
  const std::vector<Vector3>& Points;
  PointSets Sets;
  /// For each point of the boundary the first of these at the same place; None for other points.
  std::vector<Index> Place;
  bool AnyShared = false;
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

std::vector<Index> FirstAcrossSeams(const TriangleMesh& mesh, const std::vector<Vector3>& points)
{
  const std::vector<TriangleMesh::Component>& components = mesh.GetComponents();
  if (std::all_of(components.begin(), components.end(),
        [](const TriangleMesh::Component& component) { return component.Closed; }))
  {
    return {};
  }
  Seams seams(mesh, points);
  return seams.MayExist() ? seams.Join() : std::vector<Index>{};
}

MergedMesh MergedMesh::OfPoints(const Surface& surface)
{
  return { {}, TriangleMesh(surface) };
}

MergedMesh MergedMesh::OfPlaces(const Surface& surface)
{
  std::vector<Index> first = FirstAtSamePlace(surface);
  TriangleMesh mesh(Merged(surface, first));
  return { std::move(first), std::move(mesh) };
}

MergedMesh MergedMesh::AcrossSeams(const Surface& surface)
{
  TriangleMesh mesh(surface);
  std::vector<Index> first = FirstAcrossSeams(mesh, surface.Points);
  if (!first.empty())
  {
    mesh = TriangleMesh(Merged(surface, first));
  }
  return { std::move(first), std::move(mesh) };
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
