// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_NoisyShapes_h
#define DirectionFields_NoisyShapes_h

#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/PieceOfSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Averages the fitted shapes of components in which noise prevails over as much of the surface as
/// it asks for; vertices without a fit are left out.
///
/// After 4 steps it is integrals of the curvature in the edges that are averaged
/// (Curvature/ShapeIntegral.h): on uneven meshes, too, the error that noise leaves in them falls
/// with the third power of the radius, that of averaged fits with the first. The steps of a vertex
/// are 8, 16 ... 128: while noise prevails, each doubling changes the shape less than the one
/// before, and once the surface's own variation does, more. Where not even the first one pays, 2
/// steps of the fits are kept.
/// @param edges   the shape of each vertex by the angles of its edges
/// @param isNoisy of each component; the others stay as they are
/// @param piece   of which the mesh is a part; shapes become right at its own vertices and next to
///                them
void SmoothNoise(const SurfaceGeometry& geometry, const std::vector<Shape>& edges,
  const std::vector<char>& isNoisy, std::vector<Shape>& shapes,
  const PieceOfSurface& piece = PieceOfSurface());
}

#endif
