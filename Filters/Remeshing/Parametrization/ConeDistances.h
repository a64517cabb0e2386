// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConeDistances_h
#define DirectionFields_ConeDistances_h

#include "Charts/CutMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A line of the grid near a cone, a feature or the boundary, that rounding must not put onto the
/// cone: the number of the line's row, seen from the cone, has to be at least 1.
struct ConeDistance
{
  /// The vertex of the cone.
  Index Cone;
  /// A corner on the line.
  Index Triangle;
  int Corner;
  /// The line's row is the second coordinate once zeta^-Axis is applied in the cone's chart.
  int Axis;
  /// From the chart of the triangle to that of the cone.
  SymbolicTransition ToCone;

  friend bool operator==(const ConeDistance& a, const ConeDistance& b);
};

/// The edges of features and of the boundary closer than two edges of the grid to a cone, where the
/// foot of its perpendicular is on them and no other one is between. A cone that is rounded onto
/// such a line leaves triangles there, as an irregular vertex of the boundary does. The lengths are
/// those that the field asks for; around each cone the 400 nearest triangles are looked at.
/// None on a surface most of which is not in planes.
/// @param perLength 1 / h of each vertex, h the wanted length of an edge of the grid
std::vector<ConeDistance> FindConeDistances(
  const CutMesh& mesh, const std::vector<double>& perLength);
}

#endif
