// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleMesh.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>

namespace DirectionFields
{
namespace
{
/// Components of more triangles share out their own loops among the threads.
constexpr Index LargeComponent = 4 * LightPiece;
/// Small components that a thread takes at a time.
constexpr Index ComponentPiece = 64;
}

void TriangleMesh::ForEachComponent(const std::function<void(Index)>& body) const
{
  const auto isLarge = [this](Index c) { return this->Components[c].Triangles() > LargeComponent; };
  const auto components = static_cast<Index>(this->Components.size());
  for (Index c = 0; c < components; ++c)
  {
    if (isLarge(c))
    {
      body(c);
    }
  }
  ParallelFor(components, ComponentPiece,
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
  ParallelFor(this->GetNumberOfVertices(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        positions[v] = points[this->VertexPoint[v]];
      }
    });
  return positions;
}

void TriangleMesh::FlipEdge(Index edge)
{
  this->Flipped = true;
  const Index h = this->EdgeHalfEdge[edge];
  const Index g = this->Twins[h];
  const std::array<Index, 4> from = { Next(h), Previous(g), Next(g), Previous(h) };
  const std::array<Index, 4> to = { Previous(g), Next(g), Previous(h), Next(h) };
  const auto moved = [&](Index halfEdge)
  {
    const auto at = std::find(from.begin(), from.end(), halfEdge);
    return at == from.end() ? halfEdge : to[at - from.begin()];
  };
  // All is read before anything is written: sides of the two triangles may be twins.
  struct Side
  {
    Index Tail, Twin, Edge;
    bool GivesDirection, IsOutgoing, NonManifold;
  };
  std::array<Side, 4> sides;
  for (int k = 0; k < 4; ++k)
  {
    const Index tail = this->Tail(from[k]);
    const Index twin = this->Twins[from[k]];
    sides[k] = { tail, twin == None ? None : moved(twin), this->Edges[from[k]],
      this->GivesDirection(from[k]), this->VertexHalfEdge[tail] == from[k],
      this->IsNonManifold(from[k]) };
  }
  const Index i = this->Tail(h);
  const Index j = this->Tail(g);
  const bool lost[] = { this->VertexHalfEdge[i] == h, this->VertexHalfEdge[j] == g };
  for (int k = 0; k < 4; ++k)
  {
    const Side& side = sides[k];
    this->Corners[to[k]] = side.Tail;
    this->Edges[to[k]] = side.Edge;
    this->Twins[to[k]] = side.Twin;
    if (side.Twin != None)
    {
      this->Twins[side.Twin] = to[k];
    }
    if (side.GivesDirection)
    {
      this->EdgeHalfEdge[side.Edge] = to[k];
    }
    if (side.IsOutgoing)
    {
      this->VertexHalfEdge[side.Tail] = to[k];
    }
    if (!this->NonManifold.empty())
    {
      this->NonManifold[to[k]] = side.NonManifold;
    }
  }
  // The ends of the edge that was; its half-edge is never the first of a boundary vertex.
  if (lost[0])
  {
    this->VertexHalfEdge[i] = Previous(h);
  }
  if (lost[1])
  {
    this->VertexHalfEdge[j] = Previous(g);
  }
  this->Corners[h] = this->Corners[Next(g)];
  this->Corners[g] = this->Corners[Next(h)];
}
}
