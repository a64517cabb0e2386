// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntrinsicTriangulation_h
#define DirectionFields_IntrinsicTriangulation_h

#include "Geometry/IntrinsicGeometry.h"

namespace DirectionFields
{
/// The intrinsic Delaunay triangulation of a surface: the same vertices on the same surface, joined
/// by straight lines on it such that the two angles opposite of an edge sum up to no more than pi
/// (Bobenko and Springborn: A Discrete Laplace-Beltrami Operator for Simplicial Surfaces, 2007).
/// It is found by flipping edges of the surface's own triangles; boundary edges stay, and so do
/// edges where the surface was split.
///
/// Components, vertices and their tangent frames are those of the surface: angles at a vertex count
/// from the same direction, and the directions of flipped edges are tracked in the tangent cones
/// (Sharp, Soliman and Crane: Navigating Intrinsic Triangulations, 2019). So sections over the
/// vertices, and their operators, mean the same on both triangulations. Where nothing is flipped
/// nothing changes, not in a bit.
///
/// An edge may join a vertex to itself, and several edges the same vertices. Flipped triangles have
/// no input triangle.
struct IntrinsicTriangulation : IntrinsicGeometry
{
  /// Flips edges in an order that depends on nothing but their numbers. Where flips do not come to
  /// an end, as rounding might cause with extreme triangles, the last triangulation stands.
  explicit IntrinsicTriangulation(const IntrinsicGeometry& geometry);

  /// How often an edge was flipped.
  Index NumberOfFlips = 0;

  /// The sum of the angles opposite of an edge may exceed pi by this, in radians: edges of
  /// four points on a circle stay.
  static constexpr double Tolerance = 1e-10;
};
}

#endif
