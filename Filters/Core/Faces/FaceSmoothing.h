// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceSmoothing_h
#define DirectionFields_FaceSmoothing_h

#include "Faces/MovableFaces.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves vertices so that faces become regular: in each step every face says where its corners would be if
/// it was regular and nearly of the wanted size, and every vertex goes half the way to the mean, then to the
/// closest point of the surface or feature. Some careful sweeps follow, in which only such moves count that
/// make no face at the vertex worse than it was, unless all are good; then the worst faces are improved
/// one by one. The steps are shared out among the threads.
/// @param steps 0 leaves the vertices as they are
void SmoothFaces(const Faces& faces, const SmoothingDomain& domain, int steps,
  std::vector<Vector3>& points, const Progress& progress = {});
}

#endif
