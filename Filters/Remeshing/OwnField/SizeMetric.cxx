// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/SizeMetric.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Sizes at the two ends of an edge differ by no more than this factor. A triangle whose angles are
/// above 15 degrees is one in the metric, too, then.
constexpr double MostAlongEdge = 1.3;
/// Sizes that differ by less are the same.
constexpr double LeastDifference = 1.0 + 1e-6;

/// The angles of the edges around a vertex, ascending from the first one of the fan on, and of the
/// end.
void EdgeAngles(
  const IntrinsicGeometry& geometry, const std::vector<Index>& fan, std::vector<double>& angles)
{
  angles.clear();
  double angle = geometry.Transport.EdgeAngle[fan[0]];
  for (const Index h : fan)
  {
    angles.push_back(angle);
    angle += geometry.Transport.CornerAngle(geometry.Mesh, h);
  }
  angles.push_back(angle);
}

/// By how much an angle between edges turns from one list of angles of the edges to another one.
double TurnOf(
  double angle, const std::vector<double>& from, const std::vector<double>& to, bool isClosed)
{
  if (isClosed)
  {
    const double round = 2.0 * Pi;
    angle -= round * std::floor((angle - from.front()) / round);
  }
  const auto above = std::upper_bound(from.begin() + 1, from.end() - 1, angle);
  const auto k = static_cast<std::size_t>(above - from.begin()) - 1;
  const double corner = from[k + 1] - from[k];
  // Directions off the surface at its boundary turn as the edge there.
  const double part = corner > 0.0 ? std::clamp((angle - from[k]) / corner, 0.0, 1.0) : 0.0;
  return (1.0 - part) * (to[k] - from[k]) + part * (to[k + 1] - from[k + 1]);
}
}

std::vector<double> SizesOfMetric(const SurfaceGeometry& geometry, const std::vector<double>& sizes)
{
  const TriangleMesh& mesh = geometry.Mesh;
  if (sizes.empty() || mesh.GetNumberOfVertices() == 0)
  {
    return {};
  }
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> limited = sizes;
  double least = sizes[mesh.Point(0)];
  double largest = least;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double size = sizes[mesh.Point(v)];
    queue.emplace(size, v);
    least = std::min(least, size);
    largest = std::max(largest, size);
  }
  if (!(largest > LeastDifference * least))
  {
    return {};
  }
  std::vector<Index> fan;
  const auto lower = [&](Index v, double size)
  {
    double& present = limited[mesh.Point(v)];
    if (size < present)
    {
      present = size;
      queue.emplace(size, v);
    }
  };
  while (!queue.empty())
  {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > limited[mesh.Point(v)])
    {
      continue;
    }
    mesh.GetFan(v, fan);
    for (const Index h : fan)
    {
      lower(mesh.Head(h), MostAlongEdge * size);
      lower(mesh.Tail(TriangleMesh::Previous(h)), MostAlongEdge * size);
    }
  }
  return limited;
}

void TurnToFrames(const IntrinsicGeometry& from, const IntrinsicGeometry& to, int degree,
  std::vector<Complex>& section)
{
  const TriangleMesh& mesh = to.Mesh;
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      std::vector<double> anglesFrom;
      std::vector<double> anglesTo;
      for (Index v = begin; v < end; ++v)
      {
        mesh.GetFan(v, fan);
        EdgeAngles(from, fan, anglesFrom);
        EdgeAngles(to, fan, anglesTo);
        const bool isClosed = !mesh.IsBoundary(v);
        const double first = std::arg(section[v]) / degree;
        double turn = 0.0;
        int inside = 0;
        for (int k = 0; k < 2 * degree; ++k)
        {
          const double angle = first + (k - degree / 2) * 2.0 * Pi / degree;
          const bool isInside = isClosed
            ? k < degree
            : angle >= anglesFrom.front() - 1e-9 && angle <= anglesFrom.back() + 1e-9;
          if (isInside)
          {
            turn += TurnOf(angle, anglesFrom, anglesTo, isClosed);
            ++inside;
          }
        }
        if (inside > 0)
        {
          section[v] *= std::polar(1.0, degree * turn / inside);
        }
      }
    });
}
}
