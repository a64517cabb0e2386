// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshBuilder.h"

#include "Mesh/MeshOrder.h"
#include "Soup/ConnectedTriangles.h"
#include "Soup/CoveredTriangles.h"
#include "Soup/EdgeMatching.h"
#include "Soup/SortedTriangles.h"
#include "Support/RadixSort.h"
#include "Support/Threads.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>

namespace DirectionFields::Internal
{
void MeshBuilder::Build(const Surface& surface)
{
  TriangleMesh& mesh = this->Mesh;
  this->Collect(surface);
  this->LinkVertices();
  if (mesh.Components.size() == 1 && mesh.Repaired.NonManifoldPoints == 0 && mesh.Mirrors.empty())
  {
    TriangleMesh::Component& all = mesh.Components.front();
    all.FirstTriangle = all.FirstVertex = 0;
    all.EndTriangle = mesh.GetNumberOfTriangles();
    all.EndVertex = mesh.GetNumberOfVertices();
  }
  else
  {
    MeshOrder(mesh, this->TriangleComponent).Sort(surface.Points);
  }
  this->NumberEdges();
  for (TriangleMesh::Component& component : mesh.Components)
  {
    component.IsCover = mesh.Mirror(3 * component.FirstTriangle) != None;
  }
  if (!mesh.Mirrors.empty())
  {
    this->ChooseFrontVertices();
  }
}

void MeshBuilder::Collect(const Surface& surface)
{
  TriangleMesh& mesh = this->Mesh;
  SortedTriangles sorted(surface);
  const auto vertices = static_cast<Index>(sorted.Points.size());
  mesh.Repaired.CollapsedTriangles = sorted.Collapsed;
  EdgeMatching matching(sorted.Corners, vertices);
  if (matching.Edges.NonManifold > 0 || matching.Edges.Shared > 0 || matching.Edges.Duplicate > 0)
  {
    // Duplicate triangles are the one harmless cause of edges of more than two.
    mesh.Repaired.DuplicateTriangles = sorted.RemoveDuplicates();
    matching = EdgeMatching(sorted.Corners, vertices);
  }
  mesh.Repaired.NonManifoldEdges = matching.Edges.NonManifold;
  mesh.VertexPoint = std::move(sorted.Points);
  mesh.Corners = std::move(sorted.Corners);
  mesh.TriangleInput = std::move(sorted.Input);
  mesh.Twins = std::move(matching.Twins);
  mesh.NonManifold = std::move(matching.IsNonManifold);
  if (matching.Edges.Reversed > 0)
  {
    this->Orient();
  }
  else
  {
    ConnectedTriangles connected(mesh.Twins);
    this->TriangleComponent = std::move(connected.Component);
    mesh.Components.resize(connected.Count);
  }
}

void MeshBuilder::Orient()
{
  TriangleMesh& mesh = this->Mesh;
  const Index triangles = mesh.GetNumberOfTriangles();
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
    const bool orientable = this->Spread(seed, components++, members, isTurned);
    const Index reversed = this->TurnMinority(members, isTurned);
    if (orientable)
    {
      mesh.Repaired.ReversedTriangles += reversed;
    }
    else
    {
      ++mesh.Repaired.NonOrientableComponents;
      for (const Index t : members)
      {
        isCovered[t] = 1;
      }
    }
  }
  mesh.Components.resize(components);
  this->Turn(isTurned);
  if (mesh.Repaired.NonOrientableComponents > 0)
  {
    this->Cover(isCovered);
  }
}

bool MeshBuilder::Spread(
  Index seed, Index component, std::vector<Index>& members, std::vector<char>& isTurned)
{
  const TriangleMesh& mesh = this->Mesh;
  members.assign(1, seed);
  this->TriangleComponent[seed] = component;
  bool orientable = true;
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    const Index t = members[k];
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Index twin = mesh.Twins[h];
      if (twin == None)
      {
        continue;
      }
      const Index neighbour = twin / 3;
      // Twins of the same direction mean opposite windings.
      const char turn = isTurned[t] ^ (mesh.Tail(h) == mesh.Tail(twin));
      if (this->TriangleComponent[neighbour] == None)
      {
        this->TriangleComponent[neighbour] = component;
        isTurned[neighbour] = turn;
        members.push_back(neighbour);
      }
      else if (isTurned[neighbour] != turn)
      {
        orientable = false;
      }
    }
  }
  return orientable;
}

Index MeshBuilder::TurnMinority(
  const std::vector<Index>& members, std::vector<char>& isTurned) const
{
  const auto size = static_cast<Index>(members.size());
  const auto turned = static_cast<Index>(
    std::count_if(members.begin(), members.end(), [&](Index t) { return isTurned[t] != 0; }));
  const auto twice = 2 * static_cast<std::int64_t>(turned);
  const auto isEarlier = [this](Index a, Index b)
  { return this->Mesh.TriangleInput[a] < this->Mesh.TriangleInput[b]; };
  // Where there is no majority, the first triangle of the input decides.
  if (twice < size ||
    (twice == size && isTurned[*std::min_element(members.begin(), members.end(), isEarlier)] == 0))
  {
    return turned;
  }
  for (const Index t : members)
  {
    isTurned[t] ^= 1;
  }
  return size - turned;
}

void MeshBuilder::Cover(const std::vector<char>& isCovered)
{
  TriangleMesh& mesh = this->Mesh;
  const Index triangles = mesh.GetNumberOfTriangles();
  CoveredTriangles covered(isCovered, mesh.Corners, mesh.Twins);
  mesh.Mirrors = std::move(covered.Mirrors);
  mesh.IsBack = std::move(covered.IsBack);
  for (Index t = triangles; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Index front = mesh.Mirrors[t];
    mesh.TriangleInput.push_back(Index(mesh.TriangleInput[front]));
    this->TriangleComponent.push_back(Index(this->TriangleComponent[front]));
    for (Index h = 3 * t; h < 3 * t + 3 && !mesh.NonManifold.empty(); ++h)
    {
      mesh.NonManifold.push_back(char(mesh.NonManifold[mesh.Mirror(h)]));
    }
  }
}

void MeshBuilder::Turn(const std::vector<char>& turned)
{
  TriangleMesh& mesh = this->Mesh;
  const auto renumbered = [&turned](Index h)
  { return turned[h / 3] ? 3 * (h / 3) + 2 - h % 3 : h; };
  const LargeArray<Index> twins = std::move(mesh.Twins);
  const std::vector<char> nonManifold = std::move(mesh.NonManifold);
  mesh.Twins.resize(twins.size());
  mesh.NonManifold.resize(nonManifold.size());
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    mesh.Twins[renumbered(h)] = twins[h] == None ? None : renumbered(twins[h]);
    if (!nonManifold.empty())
    {
      mesh.NonManifold[renumbered(h)] = nonManifold[h];
    }
  }
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (turned[t])
    {
      std::swap(mesh.Corners[3 * t + 1], mesh.Corners[3 * t + 2]);
    }
  }
}

void MeshBuilder::LinkVertices()
{
  TriangleMesh& mesh = this->Mesh;
  const Index points = mesh.GetNumberOfVertices();
  // Any half-edge of each point, whichever thread comes last.
  std::vector<std::atomic<Index>> any(points);
  ParallelFor(mesh.GetNumberOfHalfEdges(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index h = begin; h < end; ++h)
      {
        any[mesh.Corners[h]].store(h, std::memory_order_relaxed);
      }
    });
  mesh.VertexHalfEdge.resize(points);
  const auto seen = ParallelSum<Index>(points, LightPiece, 0,
    [&](Index begin, Index end)
    {
      Index corners = 0;
      for (Index v = begin; v < end; ++v)
      {
        const Fan fan = FindFan(mesh, any[v].load(std::memory_order_relaxed));
        mesh.VertexHalfEdge[v] = fan.First;
        corners += fan.Corners;
      }
      return corners;
    });
  if (seen < mesh.GetNumberOfHalfEdges())
  {
    this->SplitPoints();
  }
}

void MeshBuilder::SplitPoints()
{
  TriangleMesh& mesh = this->Mesh;
  const LargeArray<Index> pointOf = std::move(mesh.VertexPoint);
  std::vector<char> fans(pointOf.size(), 0);
  std::vector<char> done(mesh.Corners.size(), 0);
  LargeArray<Keyed<std::uint32_t>> order;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (done[h])
    {
      continue;
    }
    const Index point = mesh.Corners[h];
    const Index first = FindFan(mesh, h).First;
    order.push_back({ static_cast<std::uint32_t>(point), first });
    for (Index k = first; k != None && !done[k]; k = mesh.NextOutgoing(k))
    {
      done[k] = 1;
    }
    // Both sides of a cover have each fan.
    const int weight = mesh.Mirror(h) != None ? 1 : 2;
    mesh.Repaired.NonManifoldPoints += fans[point] <= 2 && fans[point] + weight > 2;
    fans[point] = static_cast<char>(std::min(3, fans[point] + weight));
  }
  RadixSort(order, BitsBelow(static_cast<Index>(pointOf.size())));
  const auto vertices = static_cast<Index>(order.size());
  mesh.VertexPoint.resize(vertices);
  mesh.VertexHalfEdge.resize(vertices);
  std::fill(done.begin(), done.end(), 0);
  for (Index v = 0; v < vertices; ++v)
  {
    const Index first = order[v].Item;
    mesh.VertexPoint[v] = pointOf[order[v].Value];
    mesh.VertexHalfEdge[v] = first;
    for (Index k = first; k != None && !done[k]; k = mesh.NextOutgoing(k))
    {
      mesh.Corners[k] = v;
      done[k] = 1;
    }
  }
}

void MeshBuilder::NumberEdges()
{
  TriangleMesh& mesh = this->Mesh;
  const Index halfEdges = mesh.GetNumberOfHalfEdges();
  const auto isFirst = [&mesh](Index h) { return mesh.Twins[h] == None || h < mesh.Twins[h]; };
  std::vector<Index> number(NumberOfPieces(halfEdges, LightPiece), 0);
  ParallelFor(halfEdges, LightPiece,
    [&](Index begin, Index end)
    {
      Index count = 0;
      for (Index h = begin; h < end; ++h)
      {
        count += isFirst(h);
      }
      number[begin / LightPiece] = count;
    });
  Index edges = 0;
  for (Index& first : number)
  {
    first = std::exchange(edges, edges + first);
  }
  mesh.Edges.resize(halfEdges);
  mesh.EdgeHalfEdge.resize(edges);
  ParallelFor(halfEdges, LightPiece,
    [&](Index begin, Index end)
    {
      Index edge = number[begin / LightPiece];
      for (Index h = begin; h < end; ++h)
      {
        if (isFirst(h))
        {
          mesh.EdgeHalfEdge[edge] = h;
          mesh.Edges[h] = edge;
          if (mesh.Twins[h] != None)
          {
            mesh.Edges[mesh.Twins[h]] = edge;
          }
          ++edge;
        }
      }
    });
  for (std::size_t c = mesh.Components.size(); c-- > 0;)
  {
    TriangleMesh::Component& component = mesh.Components[c];
    component.EndEdge = edges;
    component.FirstEdge = edges = mesh.Edges[3 * component.FirstTriangle];
    component.Closed = 2 * component.Edges() == 3 * component.Triangles();
  }
}

void MeshBuilder::ChooseFrontVertices()
{
  TriangleMesh& mesh = this->Mesh;
  std::vector<Index> onFront(mesh.GetNumberOfVertices(), 0);
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    onFront[mesh.Corners[h]] += mesh.IsFront(h / 3);
  }
  mesh.IsBackVertex.assign(mesh.GetNumberOfVertices(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index mirror = mesh.MirrorVertex(v);
    mesh.IsBackVertex[v] =
      mirror != None && (onFront[v] != onFront[mirror] ? onFront[v] < onFront[mirror] : v > mirror);
  }
}
}

namespace DirectionFields
{
// The constructor is defined here so that the mesh does not depend on its builder.
TriangleMesh::TriangleMesh(const Surface& surface)
{
  MeshBuilder(*this).Build(surface);
}
}
