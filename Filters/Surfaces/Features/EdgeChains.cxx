// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/EdgeChains.h"

namespace DirectionFields::Internal
{
namespace
{
class Tracer
{
public:
  Tracer(const TriangleMesh& mesh, const std::vector<char>& isMarked)
    : Mesh(mesh)
    , EdgesAt(mesh.GetNumberOfVertices())
    , IsSeen(mesh.GetNumberOfEdges(), 0)
  {
    for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
    {
      if (isMarked[e] != 0)
      {
        this->EdgesAt[mesh.Tail(mesh.HalfEdge(e))].push_back(e);
        this->EdgesAt[mesh.Head(mesh.HalfEdge(e))].push_back(e);
      }
    }
  }

  std::vector<EdgeChain> Run()
  {
    std::vector<EdgeChain> chains;
    // From their ends first; those that are left then are closed.
    for (const bool fromEnds : { true, false })
    {
      for (Index v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
      {
        for (const Index e : this->EdgesAt[v])
        {
          if (this->IsEnd(v) == fromEnds && this->IsSeen[e] == 0)
          {
            chains.push_back(this->Follow(v, e));
          }
        }
      }
    }
    return chains;
  }

private:
  bool IsEnd(Index v) const { return this->EdgesAt[v].size() != 2 || this->Mesh.IsBoundary(v); }
  bool IsFree(Index v) const { return this->EdgesAt[v].size() == 1 && !this->Mesh.IsBoundary(v); }

  EdgeChain Follow(Index start, Index first)
  {
    EdgeChain chain;
    chain.Vertices.push_back(start);
    Index v = start;
    Index e = first;
    while (e != None)
    {
      this->IsSeen[e] = 1;
      chain.Edges.push_back(e);
      const Index h = this->Mesh.HalfEdge(e);
      v = this->Mesh.Tail(h) == v ? this->Mesh.Head(h) : this->Mesh.Tail(h);
      chain.Vertices.push_back(v);
      e = None;
      if (!this->IsEnd(v))
      {
        for (const Index next : this->EdgesAt[v])
        {
          e = this->IsSeen[next] == 0 ? next : e;
        }
      }
    }
    chain.IsClosed = v == start && !this->IsEnd(v);
    chain.EndsFreely = this->IsFree(start) || this->IsFree(v);
    return chain;
  }

  const TriangleMesh& Mesh;
  std::vector<std::vector<Index>> EdgesAt;
  std::vector<char> IsSeen;
};
}

double EdgeChain::Length(const SurfaceGeometry& geometry) const
{
  double length = 0.0;
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    length +=
      (geometry.Positions[this->Vertices[i + 1]] - geometry.Positions[this->Vertices[i]]).norm();
  }
  return length;
}

std::vector<EdgeChain> ChainsOf(const TriangleMesh& mesh, const std::vector<char>& isMarked)
{
  return Tracer(mesh, isMarked).Run();
}
}
