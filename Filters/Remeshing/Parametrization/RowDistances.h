// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RowDistances_h
#define DirectionFields_RowDistances_h

#include "Charts/CutMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A line of the grid, a feature or the boundary, near a cone or another line that rounding must
/// not put onto it: the number of the line's row, seen from there, has to be at least 1.
struct RowDistance
{
  /// The corner of a triangle, as a half-edge, that is at the cone or on the other line.
  Index From;
  /// A corner on the line.
  Index Triangle;
  int Corner;
  /// The line's row is the second coordinate once zeta^-Axis is applied in the chart of the first
  /// triangle.
  int Axis;
  /// From the chart of the triangle to that of the first one.
  SymbolicTransition ToFirst;

  friend bool operator==(const RowDistance& a, const RowDistance& b);
};

/// The edges of features and of the boundary near a cone, closer than two edges of the grid, or
/// near an edge of another one that they run along, closer than three quarters of an edge, where
/// the foot of the perpendicular is on them and no other one is between. A cone that is rounded
/// onto such a line leaves triangles there, as an irregular vertex of the boundary does; two lines
/// on one are a wall without faces. The lengths are those that the field asks for; around each cone
/// or edge the 400 nearest triangles are looked at. None on a surface most of which is not in
/// planes.
/// @param perLength 1 / h of each vertex, h the wanted length of an edge of the grid
std::vector<RowDistance> FindRowDistances(
  const CutMesh& mesh, const std::vector<double>& perLength);
}

#endif
