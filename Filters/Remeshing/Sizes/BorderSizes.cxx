// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/BorderSizes.h"

#include "Mesh/MergePoints.h"
#include "Preparation/RegionBorders.h"
#include "Preparation/SurfaceUnit.h"
#include "Sizes/SizeField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Of the diagonal: less than a thousandth, since edges do not have the wanted length exactly.
constexpr double Tolerance = 0.85e-3;
/// The input's own chords leave at least this part of it.
constexpr double LeastLeft = 0.25;
/// Edges are not made shorter for arcs that need a smaller part of the wanted length.
constexpr double Shortest = 0.55;
/// With edges longer than this part of the diagonal so many arcs would need shorter ones that the
/// faces elsewhere became worse for it.
constexpr double Coarsest = 0.035;
/// Larger turns at a point, in radians, are corners.
constexpr double Corner = 0.6;
/// By which part of the way lengths grow.
constexpr double Growth = 0.25;

/// The borders between regions as the two next vertices at each vertex.
class Borders
{
public:
  /// @param isBorder not 0 for each edge of a border
  Borders(const SurfaceGeometry& geometry, const std::vector<char>& isBorder)
    : Positions(geometry.Positions)
    , Next(Positions.size(), { None, None })
    , Count(Positions.size(), 0)
  {
    const TriangleMesh& mesh = geometry.Mesh;
    for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
    {
      if (isBorder[e] != 0)
      {
        this->Join(mesh.Tail(mesh.HalfEdge(e)), mesh.Head(mesh.HalfEdge(e)));
        this->Join(mesh.Head(mesh.HalfEdge(e)), mesh.Tail(mesh.HalfEdge(e)));
      }
    }
  }

  /// The longest edge that is near the arc at a vertex; infinite off arcs.
  double LongestAt(Index v, double tolerance) const
  {
    if (!this->IsOnArc(v))
    {
      return std::numeric_limits<double>::infinity();
    }
    const Vector3 before = this->Positions[v] - this->Positions[this->Away(v, 0)];
    const Vector3 after = this->Positions[this->Away(v, 1)] - this->Positions[v];
    const double curvature = 2.0 * Angle(before, after) / (before.norm() + after.norm());
    const double edge = 0.5 *
      ((this->Positions[this->Next[v][0]] - this->Positions[v]).norm() +
        (this->Positions[this->Next[v][1]] - this->Positions[v]).norm());
    const double left =
      std::max(tolerance - 0.125 * edge * edge * curvature, LeastLeft * tolerance);
    return std::sqrt(8.0 * left / curvature);
  }

private:
  static double Angle(const Vector3& a, const Vector3& b)
  {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  void Join(Index v, Index w)
  {
    if (this->Count[v] < 2)
    {
      this->Next[v][this->Count[v]] = w;
    }
    ++this->Count[v];
  }

  bool IsOnArc(Index v) const
  {
    return this->Count[v] == 2 &&
      Angle(this->Positions[v] - this->Positions[this->Next[v][0]],
        this->Positions[this->Next[v][1]] - this->Positions[v]) < Corner;
  }

  /// The vertex two edges away, so that stairs do not count as arcs; one where that is a corner.
  Index Away(Index v, int side) const
  {
    const Index next = this->Next[v][side];
    return !this->IsOnArc(next) ? next : this->Next[next][this->Next[next][0] == v ? 1 : 0];
  }

  const std::vector<Vector3>& Positions;
  std::vector<std::array<Index, 2>> Next;
  std::vector<Index> Count;
};
}

std::vector<double> LengthsAtBorders(
  const Surface& surface, const std::vector<Index>& regions, double edgeLength)
{
  if (!(edgeLength < Coarsest * Extent(surface)) ||
    std::adjacent_find(regions.begin(), regions.end(), std::not_equal_to<>()) == regions.end())
  {
    return {};
  }
  const SurfaceGeometry geometry(MergedMesh::AcrossSeams(surface).Mesh, surface);
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<char> isBorder = EdgesBetween(mesh, regions);
  DropStairs(geometry, isBorder, edgeLength);
  const Borders borders(geometry, isBorder);
  const double tolerance = Tolerance * Extent(surface);
  constexpr double any = std::numeric_limits<double>::infinity();
  std::vector<double> lengths(surface.Points.size(), any);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double longest = borders.LongestAt(v, tolerance);
    double& length = lengths[mesh.Point(v)];
    length =
      longest < edgeLength && longest > Shortest * edgeLength ? std::min(length, longest) : length;
  }
  if (std::all_of(lengths.begin(), lengths.end(), [&](double length) { return length == any; }))
  {
    return {};
  }
  LimitGrowth(surface, Growth, lengths);
  for (double& length : lengths)
  {
    length = length < edgeLength ? length : any;
  }
  return lengths;
}
}
