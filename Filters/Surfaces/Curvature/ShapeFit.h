// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapeFit_h
#define DirectionFields_ShapeFit_h

#include "Features/Creases.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// How a surface is curved at a vertex: the shape operator is [H + Re q, Im q; Im q, H - Re q] in
/// the vertex's frame. Lengths are in units of Metric::Unit.
struct Shape
{
  /// q, the Hopf differential.
  Complex Hopf = 0.0;
  /// H, positive where the surface is convex.
  double Mean = 0.0;
  /// The variance of q where the heights of the points that it comes from have errors of variance
  /// 1, independent of each other; negative where there is no fit.
  double Variance = -1.0;

  bool IsFitted() const { return this->Variance >= 0.0; }
};

/// The shapes of quadrics that are fitted to the neighbours of each vertex and the vertices beyond
/// the triangles around it, by least squares; where these do not determine a quadric, to all
/// neighbours of neighbours. The heights of points over the tangent plane are fitted as a function
/// of their directions and their distances in space, as z = k d^2 / 2 holds exactly for a normal
/// section that is a circle of curvature k. No quadric is fitted across creases, and none at
/// vertices on them.
std::vector<Shape> FitShapes(const SurfaceGeometry& geometry, const Creases& creases);

/// Fits the shapes again of vertices where creases have been dropped, and of those next to them.
/// @param wereOnCreases Creases::Vertex before that
void FitShapesAgain(const SurfaceGeometry& geometry, const Creases& creases,
  const std::vector<char>& wereOnCreases, std::vector<Shape>& shapes);
}

#endif
