// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RotationAtPlace_h
#define DirectionFields_RotationAtPlace_h

#include "Interpolation/FieldInterpolant.h"

#include <array>
#include <optional>

namespace DirectionFields::Internal
{
/// The most that a field is let turn along an edge where that is chosen, in radians: from a half
/// turn on it would be taken for one in the other sense.
constexpr double MostRotation = 0.99 * Pi;

/// How a field turns along the edges of a triangle around a singularity in it: its index times the
/// angle under which the edge is seen from there, less a third of the holonomy. That is below a
/// half turn along each edge, as it must be for the index to be in this triangle; where the place
/// is so near to an edge that it is not, the singularity is taken further inside.
/// @param weights  the place's barycentric coordinates
/// @param index    k, in units of 1/n
/// @param holonomy Omega of the triangle
/// @return nothing where the triangle cannot have that index
std::optional<std::array<double, 3>> RotationAround(
  const FlatTriangle& triangle, const std::array<double, 3>& weights, int index, double holonomy);

/// Whether a triangle can have an index: a field turns by less than a half turn along each of its
/// three edges.
bool CanHaveIndex(int index, double holonomy);

/// A place's barycentric coordinates, at least this much each: that far from the edges a
/// singularity can be put.
constexpr double LeastWeightOfPlace = 0.05;
std::array<double, 3> WithinTriangle(std::array<double, 3> weights);
}

#endif
