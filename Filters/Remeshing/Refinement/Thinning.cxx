// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/Thinning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Edges of this part of the longest are not split again.
constexpr double ShortPart = 0.64;

/// The longest edge that may come about at each vertex: of the given length, or between places that
/// far from the ends of one that there is. So of long edges side by side some can be collapsed.
std::vector<double> LongestEdges(
  const SurfaceGeometry& geometry, const std::vector<double>& lengths)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<double> longest = lengths;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Index tail = mesh.Tail(h);
    const Index head = mesh.Head(h);
    const double length = (geometry.Positions[head] - geometry.Positions[tail]).norm();
    longest[tail] = std::max(longest[tail], std::hypot(length, lengths[tail]));
    longest[head] = std::max(longest[head], std::hypot(length, lengths[head]));
  }
  return longest;
}

std::vector<double> AtVertices(
  const TriangleMesh& mesh, const std::vector<double>& atPoints, double factor)
{
  std::vector<double> values(mesh.GetNumberOfVertices());
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    values[v] = factor * atPoints[mesh.Point(v)];
  }
  return values;
}
}

std::vector<Triangle> TrianglesLeft(const TriangleMesh& mesh, const Decimation& decimation)
{
  std::vector<Triangle> triangles;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (decimation.IsTriangle(t) && mesh.IsFront(t))
    {
      triangles.push_back({ mesh.Point(decimation.Corner(3 * t)),
        mesh.Point(decimation.Corner(3 * t + 1)), mesh.Point(decimation.Corner(3 * t + 2)) });
    }
  }
  return triangles;
}

Decimation::Limits DecimationLimits(const SurfaceGeometry& geometry,
  const std::vector<double>& edgeLength, bool hasNeedles, std::vector<char> isKept)
{
  Decimation::Limits limits;
  limits.IsKept = std::move(isKept);
  limits.EdgeLength = AtVertices(geometry.Mesh, edgeLength, 1.0);
  if (hasNeedles)
  {
    limits.LongestEdge = LongestEdges(geometry, limits.EdgeLength);
  }
  return limits;
}

std::vector<Triangle> ThinInside(const SurfaceGeometry& geometry,
  const std::vector<char>& isFeature, const std::vector<double>& longest, std::vector<char> isKept)
{
  Decimation::Limits limits;
  limits.IsKept = std::move(isKept);
  limits.EdgeLength = AtVertices(geometry.Mesh, longest, ShortPart);
  limits.LongestEdge = LongestEdges(geometry, limits.EdgeLength);
  limits.KeepsLines = true;
  Decimation decimation(geometry.Mesh, geometry.Positions, isFeature, limits);
  decimation.Run();
  return TrianglesLeft(geometry.Mesh, decimation);
}
}
