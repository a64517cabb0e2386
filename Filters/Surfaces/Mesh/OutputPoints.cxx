// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/OutputPoints.h"

#include <numeric>

namespace DirectionFields::Internal
{
OutputPoints::OutputPoints(
  const TriangleMesh& mesh, const Surface& surface, const std::vector<Index>& merged)
  : Vertex(surface.Points.size(), None)
  , Original(surface.Points.size())
{
  std::iota(this->Original.begin(), this->Original.end(), 0);
  // The output point that each input point has in the vertex at hand.
  std::vector<Index> vertexAt(surface.Points.size(), None);
  std::vector<Index> output(surface.Points.size(), None);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (!mesh.IsFrontVertex(v))
    {
      continue;
    }
    if (merged.empty() && this->Vertex[mesh.Point(v)] == None)
    {
      this->Vertex[mesh.Point(v)] = v;
      continue;
    }
    Index h = mesh.Outgoing(v);
    do
    {
      const Index triangle = mesh.InputTriangle(h / 3);
      for (int c = 0; c < 3; ++c)
      {
        const Index point = surface.Triangles[triangle][c];
        if ((merged.empty() ? point : merged[point]) != mesh.Point(v))
        {
          continue;
        }
        if (vertexAt[point] != v)
        {
          vertexAt[point] = v;
          if (this->Vertex[point] == None)
          {
            this->Vertex[point] = v;
            output[point] = point;
          }
          else
          {
            output[point] = static_cast<Index>(this->Vertex.size());
            this->Vertex.push_back(v);
            this->Original.push_back(point);
          }
        }
        if (output[point] != point)
        {
          if (this->SplitTriangles.empty())
          {
            this->SplitTriangles = surface.Triangles;
          }
          this->SplitTriangles[triangle][c] = output[point];
        }
      }
      h = mesh.NextOutgoing(h);
    } while (h != None && h != mesh.Outgoing(v));
  }
  if (!merged.empty())
  {
    // Points of ignored triangles have no fan of their own, but a place.
    std::vector<Index> vertexOfPlace(surface.Points.size(), None);
    for (Index v = mesh.GetNumberOfVertices() - 1; v >= 0; --v)
    {
      if (mesh.IsFrontVertex(v))
      {
        vertexOfPlace[mesh.Point(v)] = v;
      }
    }
    for (std::size_t i = 0; i < merged.size(); ++i)
    {
      if (this->Vertex[i] == None)
      {
        this->Vertex[i] = vertexOfPlace[merged[i]];
      }
    }
  }
}
}
