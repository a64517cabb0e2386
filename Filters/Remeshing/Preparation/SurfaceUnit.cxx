// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/SurfaceUnit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Surfaces with triangles larger than this, or none larger than its inverse, are computed in
/// another unit: the lengths of edges to high powers would not be numbers.
constexpr double LargestSide = 1e20;
/// Surfaces farther away than this, in lengths of the longest side of their box, are computed
/// around a place of their own. Nearer ones keep six digits of a place in them at least.
constexpr double FarthestPlace = 1e10;

/// The greatest difference of coordinates from a triangle's first corner; points that no triangle
/// has do not count, and of ids of no point, and of coordinates whose sums overflow, the surface's
/// preparation tells.
double LongestSide(const Surface& surface)
{
  const auto size = static_cast<Index>(surface.Points.size());
  const auto exists = [size](Index p) { return p >= 0 && p < size; };
  double longest = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    for (int c = 1; c < 3; ++c)
    {
      if (exists(t[0]) && exists(t[c]))
      {
        const Vector3 side = surface.Points[t[c]] - surface.Points[t[0]];
        const bool haveSums = (4.0 * surface.Points[t[c]]).allFinite();
        longest = haveSums ? std::max(longest, side.lpNorm<Eigen::Infinity>())
                           : std::numeric_limits<double>::infinity();
      }
    }
  }
  return longest;
}
}

double UnitFor(const Surface& surface)
{
  const double side = LongestSide(surface);
  if (!std::isfinite(side) || !(side > 0.0) || (side <= LargestSide && side * LargestSide >= 1.0))
  {
    return 1.0;
  }
  int exponent = 0;
  std::frexp(side, &exponent);
  // The inverse of the smallest numbers has none.
  return std::ldexp(1.0, std::max(exponent, -1000));
}

Vector3 OriginFor(const Surface& surface)
{
  const auto size = static_cast<Index>(surface.Points.size());
  Eigen::AlignedBox3d box;
  for (const Triangle& t : surface.Triangles)
  {
    for (const Index p : t)
    {
      if (p >= 0 && p < size)
      {
        box.extend(surface.Points[p]);
      }
    }
  }
  Vector3 origin = Vector3::Zero();
  const double longest = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  // Coordinates whose sums overflow are left for the surface's preparation to refuse.
  const bool haveSums =
    (4.0 * box.min()).allFinite() && (4.0 * box.max()).allFinite() && std::isfinite(longest);
  if (!haveSums || !(longest > 0.0))
  {
    return origin;
  }
  for (int c = 0; c < 3; ++c)
  {
    origin[c] = std::abs(box.min()[c]) / FarthestPlace > longest ? box.min()[c] : 0.0;
  }
  return origin;
}

std::shared_ptr<const Surface> InUnit(
  std::shared_ptr<const Surface> surface, const Vector3& origin, double unit)
{
  if (unit == 1.0 && origin.isZero(0.0))
  {
    return surface;
  }
  auto scaled = std::make_shared<Surface>(*surface);
  for (Vector3& point : scaled->Points)
  {
    point = (point - origin) * (1.0 / unit);
  }
  return scaled;
}

std::vector<std::vector<Vector3>> InUnit(
  std::vector<std::vector<Vector3>> curves, const Vector3& origin, double unit)
{
  for (std::vector<Vector3>& curve : curves)
  {
    for (Vector3& point : curve)
    {
      point = (point - origin) * (1.0 / unit);
    }
  }
  return curves;
}

double Extent(const Surface& surface)
{
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index p : triangle)
    {
      if (p >= 0 && p < static_cast<Index>(surface.Points.size()) && surface.Points[p].allFinite())
      {
        box.extend(surface.Points[p]);
      }
    }
  }
  return box.isEmpty() ? 0.0 : (box.max() - box.min()).stableNorm();
}
}
