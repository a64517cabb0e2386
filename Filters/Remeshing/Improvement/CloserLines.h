// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CloserLines_h
#define DirectionFields_CloserLines_h

#include "FaceMesh/MovableFaces.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves vertices along their lines from shorter to longer edges wherever an edge strays too far,
/// and the faces around after them. No face becomes bad by it, and none that was bad becomes worse.
/// Throws Stopped.
/// @param domain that of the places
void SpaceLines(const VertexStars& faces, MovableFaces& places, const SmoothingDomain& domain,
  const Progress& progress = {});

/// How far edges of lines may stray from them, in wanted lengths, before vertices move for it;
/// before edges are split for it, which makes triangles; and the least scaled Jacobian of the
/// parts of faces that are cut then.
struct CloseLines
{
  double MostStraying;
  double MostUnsplit;
  double LeastQuality;
};

/// Splits edges of lines that stray by more than is allowed unsplit, as many as evenly spaced
/// vertices would need, unless faces became bad, or edges too short. Returns whether there were
/// any.
/// @param lines      the segments of each feature
/// @param edgeLength wanted at each vertex
bool SplitLines(FaceMesh& mesh, const std::vector<ClosestPoints>& lines,
  const std::vector<double>& edgeLength, const CloseLines& wanted);
}

#endif
