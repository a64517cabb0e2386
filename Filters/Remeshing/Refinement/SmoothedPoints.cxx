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

std::vector<Vector3> WithSmoothLines(const TriangleMesh& mesh, std::vector<Vector3> points,
  const std::vector<char>& isFeature, const std::vector<char>& isHard, int steps)
{
  std::vector<char> isFixed(mesh.GetNumberOfVertices(), 0);
  std::vector<std::vector<Index>> neighbours(mesh.GetNumberOfVertices());
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (mesh.Twin(h) == None || (!isHard.empty() && isHard[e] != 0))
    {
      isFixed[mesh.Tail(h)] = isFixed[mesh.Head(h)] = 1;
    }
    if (isFeature[e] != 0)
    {
      neighbours[mesh.Tail(h)].push_back(mesh.Head(h));
      neighbours[mesh.Head(h)].push_back(mesh.Tail(h));
    }
  }
  for (int k = 0; k < steps; ++k)
  {
    const std::vector<Vector3> old = points;
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (neighbours[v].size() == 2 && isFixed[v] == 0)
      {
        points[mesh.Point(v)] = 0.5 * old[mesh.Point(v)] +
          0.25 * (old[mesh.Point(neighbours[v][0])] + old[mesh.Point(neighbours[v][1])]);
      }
    }
  }
  return points;
}
}
