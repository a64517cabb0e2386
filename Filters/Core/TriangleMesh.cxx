// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleMesh.h"

#include "MeshError.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields
{
namespace
{
std::string Id(Index id)
{
  return std::to_string(id);
}

struct HalfEdgeKey
{
  Index Far;
  Index HalfEdge;
  bool operator<(const HalfEdgeKey& other) const
  {
    return this->Far != other.Far ? this->Far < other.Far : this->HalfEdge < other.HalfEdge;
  }
};
}

TriangleMesh::TriangleMesh(const Surface& surface)
{
  this->CollectTriangles(surface);
  if (!this->MatchEdges(false))
  {
    // Duplicate triangles are the one harmless cause of crowded edges.
    this->RemoveDuplicates();
    this->MatchEdges(true);
  }
  this->Orient();
  this->Renumber();
  this->LinkVertices();
}

void TriangleMesh::CollectTriangles(const Surface& surface)
{
  const auto points = static_cast<Index>(surface.Points.size());
  std::vector<Index> vertexOfPoint(points, None);
  this->Corners.reserve(3 * surface.Triangles.size());
  this->TriangleInput.reserve(surface.Triangles.size());
  Index firstNonFinite = None;
  Index nonFinite = 0;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& triangle = surface.Triangles[t];
    for (const Index point : triangle)
    {
      if (point < 0 || point >= points)
      {
        throw MeshError(MeshError::Kind::InvalidPointId, point,
          "A triangle uses point " + Id(point) + ", but the points are 0 to " + Id(points - 1) +
            ". Correct the connectivity of the mesh.");
      }
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
    {
      ++this->Repaired.CollapsedTriangles;
      continue;
    }
    for (const Index point : triangle)
    {
      if (vertexOfPoint[point] == None)
      {
        vertexOfPoint[point] = static_cast<Index>(this->VertexPoint.size());
        this->VertexPoint.push_back(point);
        if (!surface.Points[point].allFinite())
        {
          ++nonFinite;
          firstNonFinite = firstNonFinite == None ? point : std::min(firstNonFinite, point);
        }
      }
      this->Corners.push_back(vertexOfPoint[point]);
    }
    this->TriangleInput.push_back(static_cast<Index>(t));
  }
  if (nonFinite > 0)
  {
    throw MeshError(MeshError::Kind::NonFinitePoint, firstNonFinite,
      Id(nonFinite) + (nonFinite == 1 ? " point of the surface has" : " points of the surface have") +
        " NaN or infinite coordinates, the first is point " + Id(firstNonFinite) +
        ". Remove the cells at these points or correct their coordinates.");
  }
}

/// Fills Twins, whatever the winding. Where an edge has more than two triangles, or two triangles
/// have all corners in common: splits it if told to, else returns false.
bool TriangleMesh::MatchEdges(bool split)
{
  const Index halfEdges = this->GetNumberOfHalfEdges();
  const Index vertices = this->GetNumberOfVertices();
  this->Twins.assign(halfEdges, None);
  std::vector<Index> begin(vertices + 1, 0);
  for (Index h = 0; h < halfEdges; ++h)
  {
    ++begin[std::min(this->Tail(h), this->Head(h)) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<HalfEdgeKey> keys(halfEdges);
  {
    std::vector<Index> fill(begin.begin(), begin.end() - 1);
    for (Index h = 0; h < halfEdges; ++h)
    {
      const Index tail = this->Tail(h);
      const Index head = this->Head(h);
      keys[fill[std::min(tail, head)]++] = { std::max(tail, head), h };
    }
  }
  for (Index low = 0; low < vertices; ++low)
  {
    const auto first = keys.begin() + begin[low];
    const auto last = keys.begin() + begin[low + 1];
    std::sort(first, last);
    for (auto group = first; group != last;)
    {
      auto end = group + 1;
      while (end != last && end->Far == group->Far)
      {
        ++end;
      }
      const auto count = end - group;
      if (count == 2)
      {
        const Index g = group->HalfEdge;
        const Index h = (group + 1)->HalfEdge;
        this->Twins[g] = h;
        this->Twins[h] = g;
        if (!split && this->Tail(Previous(g)) == this->Tail(Previous(h)))
        {
          return false;
        }
      }
      else if (count > 2)
      {
        if (!split)
        {
          return false;
        }
        this->Crowded.resize(halfEdges, 0);
        for (auto key = group; key != end; ++key)
        {
          this->Crowded[key->HalfEdge] = 1;
        }
        ++this->Repaired.NonManifoldEdges;
      }
      group = end;
    }
  }
  return true;
}

void TriangleMesh::RemoveDuplicates()
{
  const Index triangles = this->GetNumberOfTriangles();
  std::vector<Triangle> sorted(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    std::copy_n(this->Corners.begin() + 3 * t, 3, sorted[t].begin());
    std::sort(sorted[t].begin(), sorted[t].end());
  }
  std::vector<Index> order(triangles);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b) { return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b; });
  std::vector<char> duplicate(triangles, 0);
  for (Index k = 1; k < triangles; ++k)
  {
    duplicate[order[k]] = sorted[order[k]] == sorted[order[k - 1]];
  }
  Index kept = 0;
  for (Index t = 0; t < triangles; ++t)
  {
    if (!duplicate[t])
    {
      std::copy_n(this->Corners.begin() + 3 * t, 3, this->Corners.begin() + 3 * kept);
      this->TriangleInput[kept++] = this->TriangleInput[t];
    }
  }
  this->Repaired.DuplicateTriangles = triangles - kept;
  this->Corners.resize(3 * kept);
  this->TriangleInput.resize(kept);
}

/// Finds the components and the triangles to turn.
void TriangleMesh::Orient()
{
  const Index triangles = this->GetNumberOfTriangles();
  this->TriangleComponent.assign(triangles, None);
  this->Turned.assign(triangles, 0);
  std::vector<Index> members;
  Index components = 0;
  for (Index seed = 0; seed < triangles; ++seed)
  {
    if (this->TriangleComponent[seed] != None)
    {
      continue;
    }
    members.assign(1, seed);
    this->TriangleComponent[seed] = components;
    Index turned = 0;
    for (std::size_t k = 0; k < members.size(); ++k)
    {
      const Index t = members[k];
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = this->Twins[h];
        if (twin == None)
        {
          continue;
        }
        const Index neighbour = twin / 3;
        // Twins of the same direction mean opposite windings.
        const char turn = this->Turned[t] ^ (this->Tail(h) == this->Tail(twin));
        if (this->TriangleComponent[neighbour] == None)
        {
          this->TriangleComponent[neighbour] = components;
          this->Turned[neighbour] = turn;
          turned += turn;
          members.push_back(neighbour);
        }
        else if (this->Turned[neighbour] != turn)
        {
          const Index point = this->VertexPoint[this->Tail(h)];
          throw MeshError(MeshError::Kind::NonOrientable, point,
            "The surface is not orientable (like a Möbius strip): its triangles cannot be wound "
            "consistently, as shows at the edge between the points " +
              Id(point) + " and " + Id(this->VertexPoint[this->Head(h)]) +
              ". Cut it open along a seam by duplicating the points there.");
        }
      }
    }
    const auto size = static_cast<Index>(members.size());
    if (2 * static_cast<std::int64_t>(turned) > size)
    {
      for (const Index t : members)
      {
        this->Turned[t] ^= 1;
      }
      turned = size - turned;
    }
    this->Repaired.ReversedTriangles += turned;
    ++components;
  }
  this->Components.resize(components);
}

/// Sorts everything by component and winds the triangles.
void TriangleMesh::Renumber()
{
  const Index triangles = this->GetNumberOfTriangles();
  std::vector<Index> next(this->Components.size() + 1, 0);
  for (const Index component : this->TriangleComponent)
  {
    ++next[component + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    this->Components[c].FirstTriangle = next[c];
    this->Components[c].EndTriangle = next[c + 1];
  }
  std::vector<Index> newTriangle(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    newTriangle[t] = next[this->TriangleComponent[t]]++;
  }
  // A turned triangle (a, b, c) becomes (a, c, b): its half-edges 0 and 2 change places.
  const auto renumbered = [&](Index h)
  {
    const Index corner = h % 3;
    return 3 * newTriangle[h / 3] + (this->Turned[h / 3] ? 2 - corner : corner);
  };
  std::vector<Index> corners(this->Corners.size());
  std::vector<Index> twins(this->Twins.size());
  std::vector<char> crowded(this->Crowded.size());
  std::vector<Index> input(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    const Index s = newTriangle[t];
    input[s] = this->TriangleInput[t];
    for (Index c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      corners[3 * s + (this->Turned[t] ? (3 - c) % 3 : c)] = this->Corners[h];
      twins[renumbered(h)] = this->Twins[h] == None ? None : renumbered(this->Twins[h]);
      if (!crowded.empty())
      {
        crowded[renumbered(h)] = this->Crowded[h];
      }
    }
  }
  this->Corners = std::move(corners);
  this->Twins = std::move(twins);
  this->Crowded = std::move(crowded);
  this->TriangleInput = std::move(input);
  this->TriangleComponent = {};
  this->Turned = {};
}

/// Numbers vertices and edges by first use. Every fan of triangles is a vertex.
void TriangleMesh::LinkVertices()
{
  const std::vector<Index> pointOf = std::move(this->VertexPoint);
  const std::vector<Index> corners = std::move(this->Corners);
  std::vector<char> fans(pointOf.size(), 0);
  this->VertexPoint.clear();
  this->VertexPoint.reserve(pointOf.size());
  this->VertexHalfEdge.reserve(pointOf.size());
  this->Corners.assign(corners.size(), None);
  this->Edges.assign(corners.size(), None);
  this->EdgeHalfEdge.reserve(corners.size() / 2 + 1);
  for (Component& component : this->Components)
  {
    component.FirstVertex = this->GetNumberOfVertices();
    component.FirstEdge = this->GetNumberOfEdges();
    component.Closed = true;
    for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; ++h)
    {
      if (this->Corners[h] == None)
      {
        this->VertexHalfEdge.push_back(this->NumberFan(h, this->GetNumberOfVertices()));
        this->VertexPoint.push_back(pointOf[corners[h]]);
        char& count = fans[corners[h]];
        this->Repaired.NonManifoldPoints += count == 1;
        count = static_cast<char>(std::min(2, count + 1));
      }
      const Index twin = this->Twins[h];
      component.Closed = component.Closed && twin != None;
      if (twin == None || h < twin)
      {
        this->Edges[h] = this->GetNumberOfEdges();
        this->EdgeHalfEdge.push_back(h);
      }
      else
      {
        this->Edges[h] = this->Edges[twin];
      }
    }
    component.EndVertex = this->GetNumberOfVertices();
    component.EndEdge = this->GetNumberOfEdges();
  }
}

/// Gives the corners of a fan their vertex. Returns the fan's first outgoing half-edge.
Index TriangleMesh::NumberFan(Index start, Index vertex)
{
  Index h = start;
  do
  {
    this->Corners[h] = vertex;
    h = this->NextOutgoing(h);
  } while (h != None && h != start);
  if (h == start)
  {
    return start;
  }
  for (h = start; this->Twins[h] != None;)
  {
    h = Next(this->Twins[h]);
    this->Corners[h] = vertex;
  }
  return h;
}
}
