// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceSmoothing_h
#define DirectionFields_FaceSmoothing_h

#include "FaceMesh/MovableFaces.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves vertices so that faces become regular: in each step every face gives the places of its
/// corners if it was regular and nearly of the wanted size, and every vertex goes half the way to
/// the mean of these places, then to the closest point of the surface or feature. The threads share
/// the vertices. Throws Stopped.
void RelaxFaces(MovableFaces& faces, int steps, const Progress& progress = {});

/// The same with care, in a few sweeps: a move counts only if it makes no face at the vertex worse,
/// unless all of them are good. Then the worst faces are improved one by one. Throws Stopped.
void ImproveFaces(MovableFaces& faces, const Progress& progress = {});
}

#endif
