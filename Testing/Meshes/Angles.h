// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Angles_h
#define DirectionFields_Angles_h

#include "Types.h"

#include <cmath>

namespace Meshes
{
/// An angle in [-pi, pi].
inline double Wrapped(double angle)
{
  return std::remainder(angle, 2.0 * DirectionFields::Pi);
}
}

#endif
