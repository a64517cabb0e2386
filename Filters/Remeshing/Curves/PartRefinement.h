// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PartRefinement_h
#define DirectionFields_PartRefinement_h

#include "Curves/SplittableMesh.h"

#include <functional>

namespace DirectionFields::Internal
{
/// How edges of parts are split.
struct PartSplits
{
  /// Whether an edge stays where it is, but for being split.
  std::function<bool(Index, Index)> IsFixed;
  /// Puts a point on an edge, turns those around, and returns its number.
  std::function<Index(Index, Index, const Vector3&)> Split;
};

/// Splits the longest edges around the slivers that are left where many points lie in one triangle
/// of a surface, as along a curve (M.-C. Rivara: New longest-edge algorithms for the refinement
/// and/or improvement of unstructured triangulations, 1997): parts become larger by and by away
/// from the curve. Left as they are are corners between two edges that stay, and slivers shorter
/// than an eighth of the distance that the points in a triangle have in the mean. At most four
/// times as many points are put in as there are already.
void RefineParts(SplittableMesh& mesh, const PartSplits& splits);
}

#endif
