// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FinishedFaces_h
#define DirectionFields_FinishedFaces_h

#include "Boundary/BoundarySpacing.h"
#include "FaceMesh/FaceMesh.h"
#include "Finishing/SurfacePatches.h"
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
  /// Edges of lines are to be close to them everywhere, which may cost triangles.
  bool HasCloseLines = false;
  /// Null where vertices may get over lines.
  const SurfacePatches* Patches = nullptr;
  /// SmoothingDomain::IsRough.
  bool IsRough = false;
};

/// What the faces are to be.
struct FinishedFaces
{
  /// The field is of degree 4.
  bool AreQuads = true;
  /// No triangles are to be among the quads.
  bool IsPure = false;
  /// Steps in which the vertices move.
  int Steps = 0;
  /// Wanted, where the size is 1.
  double EdgeLength = 0.0;
  BoundarySpacing Spacing = BoundarySpacing::Free;
  /// Rows of quads begin and end where sizes need it. No effect without steps, or where vertices of
  /// the boundary are not free.
  bool HasSizedRows = false;
};

/// Makes faces regular, all of them quads if that is wanted, and puts the vertices of the boundary
/// to their places. Throws Stopped.
BoundaryFigures FinishFaces(FaceMesh& mesh, const FinishedFaces& wanted,
  const SurfaceContext& context, const Progress& progress);
}

#endif
