// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FinishedFaces_h
#define DirectionFields_FinishedFaces_h

#include "FaceMesh/FaceMesh.h"
#include "Preparation/PreparedSurface.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The surface as the new mesh needs it.
struct SurfaceContext
{
  const Surface& Input;
  const PreparedSurface& Prepared;
  const ClosestPoints& Triangles;
  const std::vector<ClosestPoints>& Lines;
  /// Wanted length of the edges at each point of the input, relative to elsewhere; empty for the
  /// same everywhere.
  const std::vector<double>& Sizes;
};

/// Makes faces regular, and all of them quads if that is wanted. Throws Stopped.
/// @param areQuads   the field is of degree 4
/// @param isPure     no triangles are to be among the quads
/// @param steps      in which the vertices move
/// @param edgeLength wanted, where the size is 1
void FinishFaces(FaceMesh& mesh, bool areQuads, bool isPure, int steps, double edgeLength,
  const SurfaceContext& context, const Progress& progress);
}

#endif
