// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleMesh.h"

#include "Mesh/ConnectedTriangles.h"
#include "Mesh/CoveredTriangles.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/SortedTriangles.h"
#include "Support/RadixSort.h"
#include "Support/Threads.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Triangles, vertices or half-edges that a thread takes at a time.
constexpr Index PieceSize = 1 << 13;
}

TriangleMesh::TriangleMesh(const Surface& surface)
{
  this->Collect(surface);
  this->LinkVertices();
  if (this->Components.size() == 1 && this->Repaired.NonManifoldPoints == 0 && this->Images.empty())
  {
    Component& all = this->Components.front();
    all.FirstTriangle = all.FirstVertex = 0;
    all.EndTriangle = this->GetNumberOfTriangles();
    all.EndVertex = this->GetNumberOfVertices();
  }
  else
  {
    this->OrderComponents();
    this->SortVertices(surface.Points);
    this->SortTriangles();
  }
  this->NumberEdges();
  for (Component& component : this->Components)
  {
    component.IsCover = this->Mirror(3 * component.FirstTriangle) != None;
  }
  if (!this->Images.empty())
  {
    this->ChooseFrontVertices();
  }
  Free(this->TriangleComponent);
}

void TriangleMesh::ForEachComponent(const std::function<void(Index)>& body) const
{
  const auto isLarge = [this](Index c) { return this->Components[c].Triangles() > 4 * PieceSize; };
  const auto components = static_cast<Index>(this->Components.size());
  for (Index c = 0; c < components; ++c)
  {
    if (isLarge(c))
    {
      body(c);
    }
  }
  ParallelFor(components, 64,
    [&](Index begin, Index end)
    {
      for (Index c = begin; c < end; ++c)
      {
        if (!isLarge(c))
        {
          body(c);
        }
      }
    });
}

std::vector<Vector3> TriangleMesh::Positions(const std::vector<Vector3>& points) const
{
  std::vector<Vector3> positions(this->VertexPoint.size());
  PreferLargePages(positions.data(), positions.size() * sizeof(Vector3));
  ParallelFor(this->GetNumberOfVertices(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        positions[v] = points[this->VertexPoint[v]];
      }
    });
  return positions;
}

/// Matches the edges and finds the components.
void TriangleMesh::Collect(const Surface& surface)
{
  SortedTriangles sorted(surface);
  const auto vertices = static_cast<Index>(sorted.Points.size());
  this->Repaired.CollapsedTriangles = sorted.Collapsed;
  EdgeMatching matching(sorted.Corners, vertices);
  if (matching.Edges.Crowded > 0 || matching.Edges.Duplicate > 0)
  {
    // Duplicate triangles are the one harmless cause of crowded edges.
    this->Repaired.DuplicateTriangles = sorted.RemoveDuplicates();
    matching = EdgeMatching(sorted.Corners, vertices);
  }
  this->Repaired.NonManifoldEdges = matching.Edges.Crowded;
  this->VertexPoint = std::move(sorted.Points);
  this->Corners = std::move(sorted.Corners);
  this->TriangleInput = std::move(sorted.Input);
  this->Twins = std::move(matching.Twins);
  this->Crowded = std::move(matching.IsCrowded);
  if (matching.Edges.Reversed > 0)
  {
    this->Orient();
  }
  else
  {
    ConnectedTriangles connected(this->Twins);
    this->TriangleComponent = std::move(connected.Component);
    this->Components.resize(connected.Count);
  }
}

/// Finds the components, turns the minority of their triangles and covers what cannot be oriented.
void TriangleMesh::Orient()
{
  const Index triangles = this->GetNumberOfTriangles();
  this->TriangleComponent.assign(triangles, None);
  std::vector<char> isTurned(triangles, 0);
  std::vector<char> isCovered(triangles, 0);
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
    bool orientable = true;
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
        const char turn = isTurned[t] ^ (this->Tail(h) == this->Tail(twin));
        if (this->TriangleComponent[neighbour] == None)
        {
          this->TriangleComponent[neighbour] = components;
          isTurned[neighbour] = turn;
          turned += turn;
          members.push_back(neighbour);
        }
        else if (isTurned[neighbour] != turn)
        {
          orientable = false;
        }
      }
    }
    const auto size = static_cast<Index>(members.size());
    const auto twice = 2 * static_cast<std::int64_t>(turned);
    // Where there is no majority, the first triangle of the input decides.
    if (twice > size || (twice == size && isTurned[this->FirstOfInput(members)] != 0))
    {
      for (const Index t : members)
      {
        isTurned[t] ^= 1;
      }
      turned = size - turned;
    }
    if (orientable)
    {
      this->Repaired.ReversedTriangles += turned;
    }
    else
    {
      ++this->Repaired.NonOrientableComponents;
      for (const Index t : members)
      {
        isCovered[t] = 1;
      }
    }
    ++components;
  }
  this->Components.resize(components);
  this->Turn(isTurned);
  if (this->Repaired.NonOrientableComponents > 0)
  {
    CoveredTriangles covered(isCovered, this->Corners, this->Twins);
    this->Images = std::move(covered.Images);
    this->IsBack = std::move(covered.IsBack);
    for (Index t = triangles; t < this->GetNumberOfTriangles(); ++t)
    {
      const Index front = this->Images[t];
      this->TriangleInput.push_back(Index(this->TriangleInput[front]));
      this->TriangleComponent.push_back(Index(this->TriangleComponent[front]));
      for (Index h = 3 * t; h < 3 * t + 3 && !this->Crowded.empty(); ++h)
      {
        this->Crowded.push_back(char(this->Crowded[this->Mirror(h)]));
      }
    }
  }
}

/// The one that comes first in the input.
Index TriangleMesh::FirstOfInput(const std::vector<Index>& triangles) const
{
  return *std::min_element(triangles.begin(), triangles.end(),
    [this](Index a, Index b) { return this->TriangleInput[a] < this->TriangleInput[b]; });
}

/// Turns triangles: (a, b, c) becomes (a, c, b), its half-edges 0 and 2 change places.
void TriangleMesh::Turn(const std::vector<char>& turned)
{
  const auto renumbered = [&turned](Index h)
  { return turned[h / 3] ? 3 * (h / 3) + 2 - h % 3 : h; };
  const LargeArray<Index> twins = std::move(this->Twins);
  const std::vector<char> crowded = std::move(this->Crowded);
  this->Twins.resize(twins.size());
  this->Crowded.resize(crowded.size());
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    this->Twins[renumbered(h)] = twins[h] == None ? None : renumbered(twins[h]);
    if (!crowded.empty())
    {
      this->Crowded[renumbered(h)] = crowded[h];
    }
  }
  for (Index t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    if (turned[t])
    {
      std::swap(this->Corners[3 * t + 1], this->Corners[3 * t + 2]);
    }
  }
}

/// Makes every fan of triangles a vertex.
void TriangleMesh::LinkVertices()
{
  const Index points = this->GetNumberOfVertices();
  // Any half-edge of each point, whichever thread comes last.
  std::vector<std::atomic<Index>> any(points);
  ParallelFor(this->GetNumberOfHalfEdges(), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index h = begin; h < end; ++h)
      {
        any[this->Corners[h]].store(h, std::memory_order_relaxed);
      }
    });
  this->VertexHalfEdge.resize(points);
  const auto seen = ParallelSum<Index>(points, PieceSize, 0,
    [&](Index begin, Index end)
    {
      Index corners = 0;
      for (Index v = begin; v < end; ++v)
      {
        const Fan fan = this->FindFan(any[v].load(std::memory_order_relaxed));
        this->VertexHalfEdge[v] = fan.First;
        corners += fan.Corners;
      }
      return corners;
    });
  if (seen < this->GetNumberOfHalfEdges())
  {
    this->SplitPoints();
  }
}

/// The fan of a half-edge: its first outgoing half-edge, on the boundary the first one
/// counter-clockwise, else the one of the least number.
TriangleMesh::Fan TriangleMesh::FindFan(Index start) const
{
  Fan fan{ start, 0 };
  Index h = start;
  do
  {
    ++fan.Corners;
    fan.First = std::min(fan.First, h);
    h = this->NextOutgoing(h);
  } while (h != None && h != start);
  if (h == None)
  {
    for (h = start; this->Twins[h] != None; ++fan.Corners)
    {
      h = Next(this->Twins[h]);
    }
    fan.First = h;
  }
  return fan;
}

/// Numbers the fans as vertices where a point has several of them.
void TriangleMesh::SplitPoints()
{
  const LargeArray<Index> pointOf = std::move(this->VertexPoint);
  std::vector<char> fans(pointOf.size(), 0);
  std::vector<char> done(this->Corners.size(), 0);
  LargeArray<Keyed<std::uint32_t>> order;
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (done[h])
    {
      continue;
    }
    const Index point = this->Corners[h];
    const Index first = this->FindFan(h).First;
    order.push_back({ static_cast<std::uint32_t>(point), first });
    for (Index k = first; k != None && !done[k]; k = this->NextOutgoing(k))
    {
      done[k] = 1;
    }
    // Both sides of a cover have each fan.
    const int weight = this->Mirror(h) != None ? 1 : 2;
    this->Repaired.NonManifoldPoints += fans[point] <= 2 && fans[point] + weight > 2;
    fans[point] = static_cast<char>(std::min(3, fans[point] + weight));
  }
  RadixSort(order, BitsBelow(static_cast<Index>(pointOf.size())));
  const auto vertices = static_cast<Index>(order.size());
  this->VertexPoint.resize(vertices);
  this->VertexHalfEdge.resize(vertices);
  std::fill(done.begin(), done.end(), 0);
  for (Index v = 0; v < vertices; ++v)
  {
    const Index first = order[v].Item;
    this->VertexPoint[v] = pointOf[order[v].Value];
    this->VertexHalfEdge[v] = first;
    for (Index k = first; k != None && !done[k]; k = this->NextOutgoing(k))
    {
      this->Corners[k] = v;
      done[k] = 1;
    }
  }
}

/// Numbers the edges by their first half-edges.
void TriangleMesh::NumberEdges()
{
  const Index halfEdges = this->GetNumberOfHalfEdges();
  const auto isFirst = [this](Index h) { return this->Twins[h] == None || h < this->Twins[h]; };
  std::vector<Index> number(NumberOfPieces(halfEdges, PieceSize), 0);
  ParallelFor(halfEdges, PieceSize,
    [&](Index begin, Index end)
    {
      Index count = 0;
      for (Index h = begin; h < end; ++h)
      {
        count += isFirst(h);
      }
      number[begin / PieceSize] = count;
    });
  Index edges = 0;
  for (Index& first : number)
  {
    first = std::exchange(edges, edges + first);
  }
  this->Edges.resize(halfEdges);
  this->EdgeHalfEdge.resize(edges);
  ParallelFor(halfEdges, PieceSize,
    [&](Index begin, Index end)
    {
      Index edge = number[begin / PieceSize];
      for (Index h = begin; h < end; ++h)
      {
        if (isFirst(h))
        {
          this->EdgeHalfEdge[edge] = h;
          this->Edges[h] = edge;
          if (this->Twins[h] != None)
          {
            this->Edges[this->Twins[h]] = edge;
          }
          ++edge;
        }
      }
    });
  for (std::size_t c = this->Components.size(); c-- > 0;)
  {
    Component& component = this->Components[c];
    component.EndEdge = edges;
    component.FirstEdge = edges = this->Edges[3 * component.FirstTriangle];
    component.Closed = 2 * component.Edges() == 3 * component.Triangles();
  }
}

void TriangleMesh::ChooseFrontVertices()
{
  std::vector<Index> onFront(this->GetNumberOfVertices(), 0);
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    onFront[this->Corners[h]] += this->IsFront(h / 3);
  }
  this->IsBackVertex.assign(this->GetNumberOfVertices(), 0);
  for (Index v = 0; v < this->GetNumberOfVertices(); ++v)
  {
    const Index mirror = this->MirrorVertex(v);
    this->IsBackVertex[v] = mirror != None &&
      (onFront[v] != onFront[mirror] ? onFront[v] < onFront[mirror] : v > mirror);
  }
}
}
