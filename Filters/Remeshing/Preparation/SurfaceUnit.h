// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceUnit_h
#define DirectionFields_SurfaceUnit_h

#include "Surface.h"

#include <memory>

namespace DirectionFields::Internal
{
/// The unit that a surface is computed in: 1, but for very large and very small triangles. A power
/// of two, so that points keep all digits.
double UnitFor(const Surface& surface);

/// The surface in another unit.
std::shared_ptr<const Surface> InUnit(std::shared_ptr<const Surface> surface, double unit);

/// The diagonal of the box around a surface.
double Extent(const Surface& surface);
}

#endif
