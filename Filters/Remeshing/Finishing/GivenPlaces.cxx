// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/GivenPlaces.h"

#include "Distance/ClosestPoints.h"

#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The ways from a smoothed surface to the given one at each vertex, without those of the noise.
std::vector<Vector3> WaysBack(const PreparedSurface& surface)
{
  constexpr int steps = 3;
  const SurfaceGeometry& geometry = surface.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Vector3> ways = surface.GetGivenPositions();
  std::vector<double> neighbours(ways.size(), 0.0);
  for (std::size_t v = 0; v < ways.size(); ++v)
  {
    ways[v] -= geometry.Positions[v];
  }
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    neighbours[mesh.Tail(mesh.HalfEdge(e))] += 1.0;
    neighbours[mesh.Head(mesh.HalfEdge(e))] += 1.0;
  }
  for (int k = 0; k < steps; ++k)
  {
    std::vector<Vector3> sums(ways.size(), Vector3::Zero());
    for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
    {
      const Index a = mesh.Tail(mesh.HalfEdge(e));
      const Index b = mesh.Head(mesh.HalfEdge(e));
      sums[a] += ways[b];
      sums[b] += ways[a];
    }
    for (std::size_t v = 0; v < ways.size(); ++v)
    {
      ways[v] = 0.5 * ways[v] + 0.5 / neighbours[v] * sums[v];
    }
  }
  return ways;
}
}

void MoveToGiven(const PreparedSurface& surface, std::vector<ExtractedMesh>& extracted)
{
  const SurfaceGeometry& geometry = surface.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<ClosestPoints::Corners> triangles;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    triangles.push_back({ geometry.Positions[mesh.Tail(3 * t)],
      geometry.Positions[mesh.Tail(3 * t + 1)], geometry.Positions[mesh.Tail(3 * t + 2)] });
  }
  const ClosestPoints smoothed(std::move(triangles));
  const std::vector<Vector3> ways = WaysBack(surface);
  for (ExtractedMesh& part : extracted)
  {
    for (ExtractedMesh::Vertex& vertex : part.Vertices)
    {
      const ClosestPoints::Answer answer = smoothed.Find(vertex.Position);
      for (int c = 0; c < 3 && answer.Triangle != None; ++c)
      {
        vertex.Position += answer.Weights[c] * ways[mesh.Tail(3 * answer.Triangle + c)];
      }
    }
  }
}
}
