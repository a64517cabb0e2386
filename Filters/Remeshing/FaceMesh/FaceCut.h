// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceCut_h
#define DirectionFields_FaceCut_h

#include "FaceMesh/Faces.h"

#include <array>
#include <vector>

namespace DirectionFields::Internal
{
/// The two parts of a face with a new vertex on one of its edges, and the scaled Jacobian of the
/// worse one.
struct FaceParts
{
  Faces::Face First;
  Faces::Face Second;
  double Quality;
};

/// Of the ways to cut a face from a new vertex on its edge the one whose worse part is better: a
/// quad becomes a triangle and a quad, a triangle two of them.
/// @param ends  the vertices of the edge, the lower one first
/// @param place of the new vertex, whose number is that of the points
FaceParts CutAtEdge(const std::vector<Vector3>& points, const Faces::Face& face,
  const std::array<Index, 2>& ends, const Vector3& place);
}

#endif
