// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundarySides.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The segments of all lines, and the line that each is of.
struct AllSegments
{
  explicit AllSegments(const std::vector<BoundaryLine>& lines)
    : Segments(Collect(lines, this->LineOf))
  {
  }

  static std::vector<ClosestPoints::Corners> Collect(
    const std::vector<BoundaryLine>& lines, std::vector<Index>& lineOf)
  {
    std::vector<ClosestPoints::Corners> segments;
    for (std::size_t k = 0; k < lines.size(); ++k)
    {
      for (Index e = 0; e < lines[k].GetNumberOfEdges(); ++e)
      {
        const Vector3& end = lines[k].PositionAt(e + 1);
        segments.push_back({ lines[k].PositionAt(e), end, end });
        lineOf.push_back(static_cast<Index>(k));
      }
    }
    return segments;
  }

  std::vector<Index> LineOf;
  ClosestPoints Segments;
};

/// The line that the middles of most edges of a path are on, or None.
Index LineAt(const FaceMesh& mesh, const BoundaryPath& path, const AllSegments& all)
{
  std::vector<Index> found;
  const std::size_t count = path.Points.size();
  for (std::size_t k = 0; k < path.GetNumberOfEdges(); ++k)
  {
    const Vector3 middle =
      0.5 * (mesh.Points[path.Points[k]] + mesh.Points[path.Points[(k + 1) % count]]);
    const ClosestPoints::Answer answer = all.Segments.Find(middle);
    if (answer.Triangle != None)
    {
      found.push_back(all.LineOf[answer.Triangle]);
    }
  }
  std::sort(found.begin(), found.end());
  Index best = None;
  std::size_t most = 0;
  for (std::size_t k = 0, end = 0; k < found.size(); k = end)
  {
    end = static_cast<std::size_t>(
      std::upper_bound(found.begin() + static_cast<std::ptrdiff_t>(k), found.end(), found[k]) -
      found.begin());
    if (end - k > most)
    {
      most = end - k;
      best = found[k];
    }
  }
  return best;
}

/// The way from one place of a closed line to another one, from minus half a round to half a round.
double Way(double from, double to, double round)
{
  return to - from - round * std::round((to - from) / round);
}

/// A path of the mesh in the order of its line.
BoundarySide SideOf(
  const FaceMesh& mesh, const BoundaryPath& path, const BoundaryLine& line, Index number)
{
  BoundarySide side;
  side.Line = number;
  side.Vertices = path.Points;
  for (const Index v : path.Points)
  {
    side.Places.push_back(line.Find(mesh.Points[v]));
  }
  const auto round = static_cast<double>(line.GetNumberOfEdges());
  double way = 0.0;
  for (std::size_t k = 0; k + 1 < side.Places.size(); ++k)
  {
    const double step = side.Places[k + 1] - side.Places[k];
    way += line.IsClosed() ? Way(side.Places[k], side.Places[k + 1], round) : step;
  }
  if (way < 0.0)
  {
    std::reverse(side.Vertices.begin(), side.Vertices.end());
    std::reverse(side.Places.begin(), side.Places.end());
  }
  if (!line.IsClosed())
  {
    side.Places.front() = 0.0;
    side.Places.back() = round;
    return side;
  }
  // It begins where a vertex stays, else where one is nearest to a point of the line.
  const auto off = [&](std::size_t k)
  {
    const bool isFixed = mesh.Vertices[side.Vertices[k]].Line < 0;
    return std::abs(side.Places[k] - std::round(side.Places[k])) - (isFixed ? 1.0 : 0.0);
  };
  std::size_t first = 0;
  for (std::size_t k = 1; k < side.Places.size(); ++k)
  {
    first = off(k) < off(first) ? k : first;
  }
  std::rotate(side.Vertices.begin(), side.Vertices.begin() + static_cast<std::ptrdiff_t>(first),
    side.Vertices.end());
  std::rotate(side.Places.begin(), side.Places.begin() + static_cast<std::ptrdiff_t>(first),
    side.Places.end());
  const double start = side.Places.front();
  for (double& place : side.Places)
  {
    place += place < start ? round : 0.0;
  }
  side.Vertices.push_back(side.Vertices.front());
  side.Places.push_back(start + round);
  return side;
}
}

std::vector<BoundarySide> BoundarySidesOf(
  const FaceMesh& mesh, const Surface& surface, const std::vector<BoundaryLine>& lines)
{
  std::vector<std::array<Index, 2>> edges;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      edges.push_back(SortedEnds(a, b));
    }
  }
  // Paths end where lines do.
  using Place = std::array<double, 3>;
  const auto placeOf = [](const Vector3& p) { return Place{ p.x(), p.y(), p.z() }; };
  std::set<Place> ends;
  for (const BoundaryLine& line : lines)
  {
    if (!line.IsClosed())
    {
      ends.insert(placeOf(surface.Points[line.GetPoints().front()]));
      ends.insert(placeOf(surface.Points[line.GetPoints().back()]));
    }
  }
  std::vector<char> isEnd(mesh.Points.size(), 0);
  for (std::size_t v = 0; v < isEnd.size() && !ends.empty(); ++v)
  {
    isEnd[v] = ends.count(placeOf(mesh.Points[v])) > 0 ? 1 : 0;
  }
  const AllSegments all(lines);
  std::vector<BoundarySide> sides;
  std::vector<int> times(lines.size(), 0);
  for (const BoundaryPath& path : BoundaryPathsOf(edges, isEnd))
  {
    const Index line = LineAt(mesh, path, all);
    if (line != None)
    {
      ++times[line];
      if (path.IsClosed == lines[line].IsClosed())
      {
        sides.push_back(SideOf(mesh, path, lines[line], line));
      }
    }
  }
  sides.erase(std::remove_if(sides.begin(), sides.end(),
                [&](const BoundarySide& side) { return times[side.Line] > 1; }),
    sides.end());
  return sides;
}
}
