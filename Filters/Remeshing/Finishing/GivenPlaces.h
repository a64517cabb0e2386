// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GivenPlaces_h
#define DirectionFields_GivenPlaces_h

#include "Extraction/MeshExtraction.h"
#include "Preparation/PreparedSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Moves vertices that lie on a surface that was smoothed by what smoothing has moved its parts
/// there, but for noise. It shrinks thin parts, so that the closest places of the given surface may
/// be on the other side of these, or of others.
void MoveToGiven(const PreparedSurface& surface, std::vector<ExtractedMesh>& extracted);
}

#endif
