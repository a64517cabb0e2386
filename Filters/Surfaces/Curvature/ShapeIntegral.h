// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapeIntegral_h
#define DirectionFields_ShapeIntegral_h

#include "Curvature/ShapeAverages.h"
#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"

namespace DirectionFields::Internal
{
/// The integral of a shape over a third of the triangles around a vertex, with that area as its
/// weight.
WeightedShape ShapeIntegral(const SurfaceGeometry& geometry, Index v, const Shape& shape);

/// The integral of the curvature in the edges over a third of the triangles around a vertex, plus
/// what an estimate says that the edges of this mesh miss: the estimate's own integral less that of
/// the curvature in the edges of a triangulated quadric of that shape.
///
/// Errors of heights cancel in sums of the edges' curvature, as those of second derivatives by
/// differences do, and so do those of smoothly weighted sums but for the second derivatives of the
/// weights. On uneven meshes the curvature in the edges varies much without any error of heights;
/// that is what the estimate takes away. Where triangles are folded over, the edges say nothing of
/// the surface, and this is the integral of the estimate.
/// @param edges    the mean shape of these edges
/// @param estimate of the shape of the surface
WeightedShape ShapeIntegral(
  const SurfaceGeometry& geometry, Index v, const Shape& edges, const Shape& estimate);
}

#endif
