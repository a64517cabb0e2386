// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Roughness_h
#define DirectionFields_Roughness_h

#include "Geometry/SurfaceGeometry.h"

namespace DirectionFields::Internal
{
/// Whether a surface has noise of about a third of its edges, or more: whether many of its edges,
/// and more than a quarter, are sharp but no features of the usual settings. Takes time linear in
/// the edges.
bool IsRough(const SurfaceGeometry& geometry);

/// Whether more than a tenth are, as with noise of a fifth of the edges: what is a feature then is
/// told by FeaturesInNoise.
bool HasNoise(const SurfaceGeometry& geometry);
}

#endif
