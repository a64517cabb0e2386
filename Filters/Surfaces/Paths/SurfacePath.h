// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfacePath_h
#define DirectionFields_SurfacePath_h

#include "Paths/SurfaceIncidence.h"
#include "Paths/SurfaceWalk.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A straight path on a surface, that is, one that goes straight on when the triangles it crosses
/// are laid flat.
struct SurfacePath
{
  struct Station
  {
    /// Along the path from its start, which may be in its middle: negative behind that.
    double Distance;
    Vector3 Position;
    /// Unit normal of the surface; the mean of both sides where the path crosses an edge.
    Vector3 Normal;
  };
  /// At least two.
  std::vector<Station> Stations;

  /// The place at a distance, interpolated between stations.
  Station At(double distance) const;
  /// Unit vector along the path, at a bend the mean of before and after.
  Vector3 Heading(double distance) const;
  /// Unit vector to the left of the path, orthogonal to heading and normal.
  Vector3 Left(double distance) const;
};

/// Follows a unit tangent vector for a length. On the boundary the path leaves the surface and goes
/// straight on.
SurfacePath TracePath(
  const SurfaceIncidence& surface, const PathStart& start, const Vector3& direction, double length);

/// Moves a point along the surface by the part of a vector that is tangent to it; not beyond the
/// boundary.
SurfacePoint Moved(
  const SurfaceIncidence& surface, const SurfacePoint& point, const Vector3& vector);

/// Two paths from the same place as one, which runs the first one backwards.
SurfacePath Joined(const SurfacePath& backward, const SurfacePath& forward);

/// The same path with few stations: two where it is straight in space.
/// @param stations the most stations that a bent path has
SurfacePath SimplifiedPath(const SurfacePath& path, int stations);

/// How high the path rises above a plane through its start, at most.
double HeightAbove(const SurfacePath& path, const Vector3& origin, const Vector3& normal);
}

#endif
