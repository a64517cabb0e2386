// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SharpEdges_h
#define DirectionFields_SharpEdges_h

#include "Exchange/CompanionFiles.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The features of a surface as QuadWild lists them: every edge that Options::ConstrainSharpEdges
/// takes for a feature, from both of its triangles, convex or concave; and every edge of one
/// triangle or of more than two, which count as convex. Points at the same place stay apart, as
/// QuadWild reads the mesh.
///
/// Throws MeshError.
/// @param featureAngle  as Options::FeatureAngle, degrees
/// @param minimumLength as Options::MinimumFeatureLength
std::vector<SharpEdge> FindSharpEdges(
  const Surface& surface, double featureAngle, double minimumLength);
}

#endif
