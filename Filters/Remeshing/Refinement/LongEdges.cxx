// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/LongEdges.h"

#include "Geometry/DihedralAngles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace DirectionFields::Internal
{
namespace
{
/// The most triangles that a point has; 0 without any.
Index LargestValence(const Surface& surface)
{
  std::vector<Index> valences(surface.Points.size() + 1, 0);
  for (const Triangle& t : surface.Triangles)
  {
    for (const Index p : t)
    {
      // Others are an error later.
      const bool isPoint = p >= 0 && p < static_cast<Index>(surface.Points.size());
      ++valences[isPoint ? p : static_cast<Index>(surface.Points.size())];
    }
  }
  valences.back() = 0;
  return *std::max_element(valences.begin(), valences.end());
}
}

bool HasNeedles(const Surface& surface, double face)
{
  constexpr Index mostValence = 50;
  // A needle's shortest edge, as a part of a face and of its longest one.
  constexpr double thin = 0.25;
  constexpr double narrow = 0.1;
  constexpr double much = 0.05;
  if (LargestValence(surface) > mostValence)
  {
    return true;
  }
  const auto count = static_cast<Index>(surface.Points.size());
  double all = 0.0;
  double ofNeedles = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    if (!std::all_of(t.begin(), t.end(), [&](Index p) { return p >= 0 && p < count; }))
    {
      return false;
    }
    const Vector3 u = surface.Points[t[1]] - surface.Points[t[0]];
    const Vector3 v = surface.Points[t[2]] - surface.Points[t[0]];
    const double lengths[] = { u.norm(), v.norm(), (v - u).norm() };
    const auto [shortest, longest] = std::minmax_element(std::begin(lengths), std::end(lengths));
    const double area = u.cross(v).norm();
    const bool isNeedle =
      *longest > face && *shortest < thin * face && *shortest < narrow * *longest;
    all += area;
    ofNeedles += isNeedle ? area : 0.0;
  }
  return ofNeedles > much * all;
}

bool IsMostlyFlat(const SurfaceGeometry& geometry)
{
  constexpr double flat = 1.0 * Pi / 180.0;
  // Needles, this many times as long as high, are the straight strips of cones and cylinders.
  constexpr double needle = 4.0;
  // A triangle between edges sharper than this is a facet of its own.
  constexpr double sharp = 25.0 * Pi / 180.0;
  // One at an edge bent like this, or at the boundary, is part of a wall or lid that ends there.
  constexpr double rim = 60.0 * Pi / 180.0;
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<double> dihedral = DihedralAngles(geometry);
  double all = 0.0;
  double inPlane = 0.0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    bool hasNeighbour = false;
    bool isAlone = true;
    bool isFacet = true;
    bool isAtRim = false;
    double squaredLength = 0.0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      isAlone = isAlone && mesh.Twin(h) == None;
      const double angle = mesh.Twin(h) == None ? Pi : std::abs(dihedral[mesh.Edge(h)]);
      isFacet = isFacet && angle > sharp;
      isAtRim = isAtRim || angle > rim;
      hasNeighbour = hasNeighbour || angle < flat;
      squaredLength = std::max(squaredLength, geometry.Lengths.SquaredLength[mesh.Edge(h)]);
    }
    all += geometry.Lengths.Area[t];
    const bool isNeedle = squaredLength > needle * 2.0 * geometry.Lengths.Area[t];
    inPlane +=
      hasNeighbour || isAlone || isFacet || isAtRim || isNeedle ? geometry.Lengths.Area[t] : 0.0;
  }
  return inPlane > 0.5 * all;
}

std::vector<char> FindLongEdges(
  const SurfaceGeometry& geometry, const std::vector<double>& longest, Index mostMiddles)
{
  const TriangleMesh& mesh = geometry.Mesh;
  // How many times as long as they may be.
  std::vector<double> excess(mesh.GetNumberOfEdges(), 0.0);
  std::vector<double> tooLong;
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index tail = mesh.Tail(mesh.HalfEdge(e));
    const Index head = mesh.Head(mesh.HalfEdge(e));
    const double most = std::min(longest[mesh.Point(tail)], longest[mesh.Point(head)]);
    excess[e] = (geometry.Positions[head] - geometry.Positions[tail]).stableNorm() / most;
    if (excess[e] > 1.0)
    {
      tooLong.push_back(excess[e]);
    }
  }
  double limit = 1.0;
  const auto room = static_cast<std::size_t>(std::max<Index>(0, mostMiddles));
  if (tooLong.size() > room)
  {
    const auto last = tooLong.begin() + static_cast<std::ptrdiff_t>(room);
    std::nth_element(tooLong.begin(), last, tooLong.end(), std::greater<>());
    limit = *last;
  }
  std::vector<char> isLong(excess.size(), 0);
  for (std::size_t e = 0; e < excess.size(); ++e)
  {
    isLong[e] = excess[e] > limit ? 1 : 0;
  }
  return isLong;
}
}
