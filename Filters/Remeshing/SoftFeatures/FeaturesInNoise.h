// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeaturesInNoise_h
#define DirectionFields_FeaturesInNoise_h

#include "Features/KeptFeatures.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Not 0 for each edge that is a feature of a surface with noise. Noise bends single edges as much
/// as features do, but not what lies to both sides of a line, seen from some triangles away; and
/// parts that are thin are bent there, too, but to both sides of each line as much as across it.
/// So edges count that are sharp from there as well, and chains of them that are bent across by
/// several times as much as beside them, and are some edges long where they end freely. Takes a
/// time linear in the edges.
std::vector<char> FeaturesInNoise(const SurfaceGeometry& geometry, const FeatureSettings& settings);
}

#endif
