// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldDifference_h
#define DirectionFields_FieldDifference_h

#include "Interpolation/GivenField.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields
{
/// How far the directions of two fields of the same degree n on one surface are apart.
struct FieldDifference
{
  /// Angle in degrees from a direction of the one field to the nearest of the other, 0 to 180/n, at
  /// each point of the surface. Not a number where one of them has no direction, zero at points
  /// that no triangle uses.
  std::vector<double> Angle;
  /// Of the points where both have directions: the mean, weighted by area, and the maximum. Ghosts
  /// do not count. 0 where there are none.
  double Mean = 0.0;
  double Maximum = 0.0;
};

/// Takes linear time, on the threads of the scope. Both orders of the directions give the same
/// angles.
/// @param field which of the points are one, and their tangent planes
/// @param one   directions of the field's degree at the points of its surface
/// @param other as many
FieldDifference Compare(
  const GivenField& field, const PointDirections& one, const PointDirections& other);

/// A singularity of one of two fields.
struct ComparedSingularity
{
  /// 0 or 1.
  int Field;
  /// In units of 1/n.
  int SingularityIndex;
  /// The triangle of the surface.
  Index Triangle;
  /// Where the field vanishes.
  Vector3 Position;
  /// The singularity of the other field that it is matched with; None for none.
  Index Match = None;
  /// The distance to that along the surface, in its unit of length; not a number without a match.
  double Distance;
};

/// The singularities of two fields on one surface, those of the first one first, by triangles.
/// Singularities of the same index are matched in pairs: again and again the two unmatched ones
/// that are nearest to each other along the surface. Takes a few rounds of time n log n each; a
/// round matches all pairs of mutual nearest neighbours. After MostRounds the rest stays unmatched.
/// Throws Stopped.
std::vector<ComparedSingularity> MatchSingularities(
  const GivenField& one, const GivenField& other, const Progress& progress = {});

constexpr int MostRounds = 64;
}

#endif
