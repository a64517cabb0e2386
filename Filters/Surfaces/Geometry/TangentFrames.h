// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TangentFrames_h
#define DirectionFields_TangentFrames_h

#include "Geometry/Connection.h"

#include <vector>

namespace DirectionFields
{
/// Where the tangent cones of the vertices lie in space.
struct TangentFrames
{
  /// @param positions of the vertices
  TangentFrames(
    const TriangleMesh& mesh, const Connection& connection, const std::vector<Vector3>& positions);

  /// Unit normal of each vertex: mean of the triangles' normals, weighted by corner angle. Any unit
  /// vector where that vanishes.
  std::vector<Vector3> Normal;
  /// Unit tangent vector of angle 0 of each vertex. Fits the projected directions of all edges at
  /// once, X ~ sum over edges of exp(-i theta) p, so that it depends on no reference edge.
  std::vector<Vector3> X;
  /// Normal x X, the tangent vector of angle pi / 2 of a vertex.
  Vector3 Y(Index vertex) const { return this->Normal[vertex].cross(this->X[vertex]); }
  /// The tangential part of a vector at a vertex as a complex number.
  Complex Tangential(Index vertex, const Vector3& vector) const
  {
    return { vector.dot(this->X[vertex]), vector.dot(this->Y(vertex)) };
  }
};
}

#endif
