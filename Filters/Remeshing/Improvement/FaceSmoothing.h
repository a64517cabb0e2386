// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceSmoothing_h
#define DirectionFields_FaceSmoothing_h

#include "FaceMesh/MovableFaces.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves vertices so that faces become regular: in each step every face says where its corners would be if
/// it was regular and nearly of the wanted size, and every vertex goes half the way to the mean, then to the
/// closest point of the surface or feature. The vertices are shared out among the threads. Throws Stopped.
void RelaxFaces(MovableFaces& faces, int steps, const Progress& progress = {});

/// The same with care, in a few sweeps in which only such moves count that make no face at the vertex worse than it
/// was, unless all are good; then the worst faces are improved one by one. Throws Stopped.
void ImproveFaces(MovableFaces& faces, const Progress& progress = {});
}

#endif
