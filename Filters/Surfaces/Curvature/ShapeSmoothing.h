// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapeSmoothing_h
#define DirectionFields_ShapeSmoothing_h

#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/PieceOfSurface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Averages fitted shapes over the surroundings of their vertices, the better fits counting for
/// more; vertices without a fit are left out. Each step takes the mean with the neighbours, carried
/// along the edges.
///
/// Before that they are corrected: the shapes of the edges are off by much, but not to one side,
/// while a quadric through a wider surrounding is. Where their difference varies little from vertex
/// to vertex it is the error of the quadrics, as on even meshes.
///
/// Where the scale is to be found, the steps of a vertex are 0, 1, 2, 4 ... 64: while noise
/// prevails, each doubling changes the shape less than the one before, and once the surface's own
/// variation does, more. A vertex keeps the shape from before that, which its neighbours use in
/// their further steps.
///
/// Components most of whose vertices go on for long because of noise of at most a tenth of the mean
/// edge are left as they are, for SmoothNoise of Curvature/NoisyShapes.h.
/// @param edges the shape of each vertex by the angles of its edges
/// @param rings the radius of the surroundings in edges; 0 to find it
/// @param piece of which the mesh is a part; shapes become right at its own vertices and next to
///              them
/// @return whether each component is left because of noise; none is where the radius is given
std::vector<char> SmoothShapes(const SurfaceGeometry& geometry, const std::vector<Shape>& edges,
  double rings, std::vector<Shape>& shapes, const PieceOfSurface& piece = PieceOfSurface());

/// Averages the tangential parts of symmetric tensors, given as shapes are: q and H of each vertex,
/// of any unit. All count the same and none is corrected; scales are found as those of shapes.
/// @param edges   the radius of the surroundings in edges; 0 to find it
/// @param tensors the variance of each is, afterwards, that of the noise left in q: estimated from
///                the differences between neighbours
void SmoothTensors(const SurfaceGeometry& geometry, double edges, std::vector<Shape>& tensors);
}

#endif
