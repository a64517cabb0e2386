// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/DoubleEdges.h"

#include <vector>

namespace DirectionFields::Internal
{
void SplitDoubleEdges(ExtractionMesh& mesh)
{
  // The half-edge from the current vertex to each other one.
  std::vector<Index> edgeTo(mesh.GetNumberOfVertices(), None);
  std::vector<Index> star;
  const Index vertices = mesh.GetNumberOfVertices();
  for (Index v = 0; v < vertices; ++v)
  {
    mesh.GetStar(v, star);
    Index other = None;
    for (const Index h : star)
    {
      Index& known = edgeTo[mesh.Head(h)];
      if (known != None)
      {
        other = mesh.IsFeature(h) ? known : h;
      }
      known = h;
    }
    for (const Index h : star)
    {
      edgeTo[mesh.Head(h)] = None;
    }
    if (other != None)
    {
      const GridPoint& p = mesh.Place(other);
      const GridPoint& q = mesh.Place(ExtractionMesh::Next(other));
      const Vector3 middle =
        0.5 * mesh.Position(mesh.Tail(other)) + 0.5 * mesh.Position(mesh.Head(other));
      const Index fresh = mesh.SplitEdge(other, { (p.A + q.A) / 2, (p.B + q.B) / 2 }, middle);
      mesh.SetKept(fresh, true);
      edgeTo.resize(mesh.GetNumberOfVertices(), None);
      // There may be more of them.
      --v;
    }
  }
}
}
