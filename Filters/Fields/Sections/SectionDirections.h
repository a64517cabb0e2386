// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SectionDirections_h
#define DirectionFields_SectionDirections_h

#include "Geometry/TangentFrames.h"

#include <vector>

namespace DirectionFields::Internal
{
/// One of the n directions of a section of degree n at each vertex, as a unit tangent vector in
/// space; zero where the section is 0.
std::vector<Vector3> DirectionsOf(
  const std::vector<Complex>& section, const TangentFrames& frames, int degree);
}

#endif
