// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Decimation/Decimation.h"

#include <algorithm>
#include <cstdlib>

namespace DirectionFields::Internal
{
namespace
{
/// Components with fewer vertices are left alone.
constexpr Index LeastVertices = 100;
}

void Decimation::FindKinds(const TriangleMesh& mesh)
{
  const Index vertices = mesh.GetNumberOfVertices();
  Index points = 0;
  for (Index v = 0; v < vertices; ++v)
  {
    points = std::max(points, mesh.Point(v) + 1);
  }
  std::vector<Index> vertexOf(points, None);
  std::vector<char> isShared(vertices, 0);
  for (Index v = 0; v < vertices; ++v)
  {
    Index& other = vertexOf[mesh.Point(v)];
    if (other != None)
    {
      isShared[other] = isShared[v] = 1;
    }
    other = v;
  }
  std::vector<unsigned char> count(vertices, 0);
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const bool isFirst = mesh.Twin(h) < h;
    if (this->IsFeature[h] != 0 && isFirst)
    {
      for (const Index v : { mesh.Tail(h), mesh.Head(h) })
      {
        count[v] = static_cast<unsigned char>(std::min(3, count[v] + 1));
      }
    }
  }
  for (Index v = 0; v < vertices; ++v)
  {
    this->Kinds[v] = count[v] == 0 ? Kind::Free : count[v] == 2 ? Kind::OnFeature : Kind::Fixed;
    const bool isKept = !this->Limit.IsKept.empty() && this->Limit.IsKept[v] != 0;
    if (isShared[v] != 0 || isKept || (this->Limit.KeepsLines && count[v] != 0))
    {
      this->Kinds[v] = Kind::Fixed;
    }
  }
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    if (component.IsCover || component.Vertices() < LeastVertices)
    {
      std::fill(this->Kinds.begin() + component.FirstVertex,
        this->Kinds.begin() + component.EndVertex, Kind::Fixed);
    }
  }
}

void Decimation::FindApart(const TriangleMesh& mesh)
{
  if (this->Limit.LongestEdge.empty())
  {
    return;
  }
  std::vector<char> isApart(mesh.GetNumberOfVertices(), 0);
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Index tail = mesh.Tail(h);
    const Index head = mesh.Head(h);
    if (std::abs(tail - head) > BlockSize / 2)
    {
      isApart[tail] = isApart[head] = 1;
    }
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (isApart[v] != 0 && this->Kinds[v] != Kind::Fixed)
    {
      this->Apart.push_back(v);
    }
  }
}
}
