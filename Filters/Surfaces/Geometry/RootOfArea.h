// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RootOfArea_h
#define DirectionFields_RootOfArea_h

#include "Geometry/Metric.h"

#include <cmath>
#include <cstddef>

namespace DirectionFields::Internal
{
/// The root of the area of all components, in the unit of the surface. The area itself has no
/// number where that is large or small.
inline double RootOfArea(const Metric& lengths)
{
  double root = 0.0;
  for (std::size_t c = 0; c < lengths.Unit.size(); ++c)
  {
    root = std::hypot(root, lengths.Unit[c] * std::sqrt(lengths.ComponentArea[c]));
  }
  return root;
}
}

#endif
