// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundaryDistance.h"

#include "Distance/ClosestPoints.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// A segment as a triangle without area.
using Segments = std::vector<ClosestPoints::Corners>;

Segments SegmentsOf(const std::vector<BoundaryLine>& lines)
{
  Segments segments;
  for (const BoundaryLine& line : lines)
  {
    for (Index e = 0; e < line.GetNumberOfEdges(); ++e)
    {
      const Vector3& end = line.PositionAt(e + 1);
      segments.push_back({ line.PositionAt(e), end, end });
    }
  }
  return segments;
}

Segments SegmentsOf(const std::vector<Vector3>& points, const Faces& faces)
{
  std::vector<std::array<Index, 2>> edges;
  for (const Faces::Face& face : faces.Corners)
  {
    for (int c = 0; c < Faces::Size(face); ++c)
    {
      edges.push_back(SortedEnds(face[c], face[(c + 1) % Faces::Size(face)]));
    }
  }
  std::sort(edges.begin(), edges.end());
  Segments segments;
  for (std::size_t k = 0, end = 0; k < edges.size(); k = end)
  {
    for (end = k + 1; end < edges.size() && edges[end] == edges[k];)
    {
      ++end;
    }
    if (end - k == 1)
    {
      const Vector3& head = points[edges[k][1]];
      segments.push_back({ points[edges[k][0]], head, head });
    }
  }
  return segments;
}

double LargestDistance(const Segments& from, const Segments& to, double step)
{
  const ClosestPoints lines(to);
  double largest = 0.0;
  for (const ClosestPoints::Corners& segment : from)
  {
    const Vector3 edge = segment[1] - segment[0];
    const auto parts = static_cast<Index>(std::max(1.0, std::ceil(edge.norm() / step)));
    for (Index k = 0; k < parts; ++k)
    {
      const double part = static_cast<double>(k) / static_cast<double>(parts);
      largest = std::max(largest, lines.Find(segment[0] + part * edge).SquaredDistance);
    }
  }
  return std::sqrt(largest);
}
}

double BoundaryDistance(const std::vector<BoundaryLine>& lines, const std::vector<Vector3>& points,
  const Faces& faces, double step)
{
  const Segments ofSurface = SegmentsOf(lines);
  const Segments ofMesh = SegmentsOf(points, faces);
  return ofSurface.empty() || ofMesh.empty()
    ? 0.0
    : std::max(LargestDistance(ofSurface, ofMesh, step), LargestDistance(ofMesh, ofSurface, step));
}
}
