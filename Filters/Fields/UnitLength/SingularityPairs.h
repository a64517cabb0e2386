// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularityPairs_h
#define DirectionFields_SingularityPairs_h

#include "UnitLength/UnitLengthProblem.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Two singularities that may cancel each other, or one that may leave over the boundary.
struct SingularityPair
{
  /// The triangle that the path begins in.
  Index From;
  /// The triangle with the singularity of the other sign; None where the path leaves over the
  /// boundary.
  Index To;
  /// The change of the index in From, 1 or -1.
  int Change;
  /// The length of the path through the triangles.
  double Distance;
  /// The half-edges that the path crosses, each in the triangle that it comes from.
  std::vector<Index> Crossed;
};

/// For each triangle of positive index the two nearest of negative index or the boundary, for each
/// of negative index the boundary if it is near, by ascending distance. Paths lead from triangle to
/// triangle and cross no edge whose ends are both given. Takes time linear in the triangles that
/// are searched, but for the queue.
/// @param indices of the component's triangles
std::vector<SingularityPair> FindPairs(
  const UnitLengthProblem& problem, const std::vector<int>& indices);
}

#endif
