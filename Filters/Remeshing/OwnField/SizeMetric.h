// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SizeMetric_h
#define DirectionFields_SizeMetric_h

#include "Geometry/SurfaceGeometry.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Sizes for the metric of a field: no larger than those given, and along no edge by more than a
/// factor of 1.3 apart, and less along short edges of needles and caps, since lengths divided by
/// sizes that jump are no lengths of triangles.
/// Empty where the sizes are the same everywhere, or none are given.
/// @param sizes at the points of the surface, above 0
std::vector<double> SizesOfMetric(
  const SurfaceGeometry& geometry, const std::vector<double>& sizes);

/// Turns a section over the vertices from the frames of one metric to those of another one of the
/// same mesh: a direction keeps its part of the angle between the two edges that it is between.
/// @param from, to the same mesh in two metrics
void TurnToFrames(const IntrinsicGeometry& from, const IntrinsicGeometry& to, int degree,
  std::vector<Complex>& section);
}

#endif
