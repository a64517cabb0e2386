// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_UprightFaces_h
#define DirectionFields_UprightFaces_h

#include "Finishing/FinishedFaces.h"

namespace DirectionFields::Internal
{
struct UprightFaces
{
  BoundaryFigures Boundary;
  /// Faces that are turned over all the same.
  Index Turned = 0;
};

/// FinishFaces, and if single faces are turned over then, as at the corners where features of a
/// part meet, once more with vertices that do not get over features. That mesh is the result if no
/// more of its faces are turned over, and fewer are flawed. Where many are turned over the features
/// are noise or creases, which faces cannot keep apart. Throws Stopped.
UprightFaces FinishUpright(FaceMesh& mesh, const FinishedFaces& wanted,
  const SurfaceContext& context, const FeatureLines& features, const Progress& progress);
}

#endif
