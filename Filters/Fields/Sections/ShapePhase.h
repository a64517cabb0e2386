// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapePhase_h
#define DirectionFields_ShapePhase_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Turns a section whose global phase is free so that its directions are, over the whole component,
/// as close as they can be to those in which the surface is bent least, weighted by how much more
/// it is bent across them: along sharp edges and in principal directions. The energy of a section
/// without guidance and given values does not change. Nothing is done for odd degrees, whose
/// directions have signs; on double covers; and where the shape does not tell, as on spheres and
/// planes, or tells no more than noise would.
/// @param dihedralAngles of each edge of the mesh, radians
/// @param u              over the vertices of the component
void TurnTowardsShape(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles,
  std::size_t component, int degree, ComplexVector& u);
}

#endif
