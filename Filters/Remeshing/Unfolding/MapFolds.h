// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MapFolds_h
#define DirectionFields_MapFolds_h

#include "Progress.h"
#include "Unfolding/MovablePlaces.h"

namespace DirectionFields::Internal
{
/// Moves vertices of a map around the triangles that it flips, such that fewer are flipped. Grid
/// points stay, and vertices of features stay on their lines: the map suits a mesh as before, but
/// where it was folded. Folds remain where no map with these grid points is without, or where none
/// is found. Throws Stopped.
void UnfoldTriangles(MovablePlaces& places, const Progress& progress = {});
}

#endif
