// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceUnit_h
#define DirectionFields_SurfaceUnit_h

#include "Surface.h"

#include <memory>
#include <vector>

namespace DirectionFields::Internal
{
/// The unit that a surface is computed in: 1, but for very large and very small triangles. A power
/// of two, so that points keep all digits.
double UnitFor(const Surface& surface);

/// The place that a surface is computed around: 0 in each coordinate, but where the surface is so
/// far from there, for its size, that sums of coordinates would lose its shape. Differences of
/// coordinates from that place are exact.
Vector3 OriginFor(const Surface& surface);

/// The surface around another place and in another unit.
std::shared_ptr<const Surface> InUnit(
  std::shared_ptr<const Surface> surface, const Vector3& origin, double unit);

/// Curves on the surface likewise.
std::vector<std::vector<Vector3>> InUnit(
  std::vector<std::vector<Vector3>> curves, const Vector3& origin, double unit);

/// The diagonal of the box around a surface.
double Extent(const Surface& surface);
}

#endif
