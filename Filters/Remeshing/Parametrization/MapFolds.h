// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MapFolds_h
#define DirectionFields_MapFolds_h

#include "Parametrization/MovablePlaces.h"

namespace DirectionFields::Internal
{
/// Moves vertices of a map around the triangles that it flips, such that fewer are flipped. Grid
/// points stay, and vertices of features stay on them, so that the map is as good for a mesh, but
/// where it is folded. Folds remain where no map with these grid points is without, or none is found.
void UnfoldTriangles(MovablePlaces& places);
}

#endif
