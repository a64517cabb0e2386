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
/// Sizes at the two ends of an edge differ by no more than this factor, and along short edges of a
/// needle by less: else their lengths in the metric would not be those of a triangle.
constexpr double MostAlongEdge = 1.3;
/// Sizes that differ by less are the same.
constexpr double LeastDifference = 1.0 + 1e-6;

/// The factor by which sizes may differ at the ends of an edge of a triangle. Along the two shorter
/// edges a and b beside c it is no more than (a + b) / c: if the size between them were larger by
/// the square of that, a and b would be as long as c together.
double GrowthAlong(const SurfaceGeometry& geometry, Index triangle, Index edge)
{
  double longest = 0.0;
  double sum = 0.0;
  for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
  {
    const double length = std::sqrt(geometry.Lengths.SquaredLength[geometry.Mesh.Edge(h)]);
    longest = std::max(longest, length);
    sum += length;
  }
  const double length = std::sqrt(geometry.Lengths.SquaredLength[edge]);
  if (!(length < longest))
  {
    return MostAlongEdge;
  }
  const double others = (sum - longest) / longest;
  return std::max(1.0, std::min(std::pow(MostAlongEdge, length / longest), others));
}

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
  const Index vertices = mesh.GetNumberOfVertices();
  if (sizes.empty() || vertices == 0)
  {
    return {};
  }
  // Sheets that meet at a point have a vertex each there.
  std::vector<Index> firstOf(sizes.size(), None);
  std::vector<Index> nextOf(static_cast<std::size_t>(vertices), None);
  double least = sizes[mesh.Point(0)];
  double largest = least;
  for (Index v = 0; v < vertices; ++v)
  {
    nextOf[v] = std::exchange(firstOf[mesh.Point(v)], v);
    least = std::min(least, sizes[mesh.Point(v)]);
    largest = std::max(largest, sizes[mesh.Point(v)]);
  }
  if (!(largest > LeastDifference * least))
  {
    return {};
  }
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> limited = sizes;
  for (Index point = 0; point < static_cast<Index>(sizes.size()); ++point)
  {
    if (firstOf[point] != None)
    {
      queue.emplace(sizes[point], point);
    }
  }
  const auto lower = [&](Index triangle, Index edge, Index point, double size)
  {
    const double limit = GrowthAlong(geometry, triangle, edge) * size;
    if (limit < limited[point])
    {
      limited[point] = limit;
      queue.emplace(limit, point);
    }
  };
  std::vector<Index> fan;
  while (!queue.empty())
  {
    const auto [size, point] = queue.top();
    queue.pop();
    if (size > limited[point])
    {
      continue;
    }
    for (Index v = firstOf[point]; v != None; v = nextOf[v])
    {
      mesh.GetFan(v, fan);
      for (const Index h : fan)
      {
        const Index back = TriangleMesh::Previous(h);
        lower(h / 3, mesh.Edge(h), mesh.Point(mesh.Head(h)), size);
        lower(h / 3, mesh.Edge(back), mesh.Point(mesh.Tail(back)), size);
      }
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
