// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/SmoothedPoints.h"

#include <utility>

namespace DirectionFields::Internal
{
std::vector<Vector3> SmoothedPoints(const SurfaceGeometry& geometry, std::vector<Vector3> points,
  const std::vector<char>& isFeature, int steps)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Index count = mesh.GetNumberOfVertices();
  std::vector<double> neighbours(count, 0.0);
  std::vector<char> isFixed(count, 0);
  std::vector<std::array<Index, 2>> edges(mesh.GetNumberOfEdges());
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    edges[e] = { mesh.Tail(h), mesh.Head(h) };
    for (const Index v : edges[e])
    {
      neighbours[v] += 1.0;
      isFixed[v] = isFixed[v] != 0 || isFeature[e] != 0 || mesh.Twin(h) == None ? 1 : 0;
    }
  }
  std::vector<Vector3> positions = geometry.Positions;
  std::vector<Vector3> sums;
  for (int k = 0; k < steps; ++k)
  {
    sums.assign(count, Vector3::Zero());
    for (const auto& [a, b] : edges)
    {
      sums[a] += positions[b];
      sums[b] += positions[a];
    }
    for (Index v = 0; v < count; ++v)
    {
      if (isFixed[v] == 0)
      {
        positions[v] = 0.5 * positions[v] + 0.5 / neighbours[v] * sums[v];
      }
    }
  }
  for (Index v = 0; v < count; ++v)
  {
    points[mesh.Point(v)] = positions[v];
  }
  return points;
}
}
