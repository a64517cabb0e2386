// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Connection_h
#define DirectionFields_Connection_h

#include "Geometry/Metric.h"
#include "Mesh/TriangleMesh.h"
#include "Support/LargeArray.h"

#include <vector>

namespace DirectionFields
{
/// Discrete Levi-Civita connection of a mesh: angles in the tangent cones of the vertices, scaled
/// to close up to 2 pi at interior vertices and unscaled at boundary vertices (a flat patch stays
/// flat), and the parallel transport along edges. For vectors; a field of degree n takes n times
/// the rotations and curvatures.
///
/// Angles at a vertex count counter-clockwise from a reference edge: on the boundary the first edge
/// of the fan, else the edge to the neighbour of lexicographically smallest coordinates, so that
/// they depend on no numbering. KCPS13 section 6.1; the holonomy here is never wrapped.
struct Connection
{
  /// @param positions of the vertices
  Connection(const TriangleMesh& mesh, const Metric& metric, const std::vector<Vector3>& positions);

  /// theta_i(ij) of each half-edge i -> j, radians: from 0 to less than AngleSum; after flips of
  /// edges it may be larger.
  LargeArray<double> EdgeAngle;
  /// The factor of the corner angles of each vertex: 2 pi over their sum, on the boundary 1.
  LargeArray<double> Scale;
  /// Sum of the scaled corner angles of each vertex: 2 pi in the interior; on the boundary the
  /// angle of the last edge of the fan, which has no outgoing half-edge.
  LargeArray<double> AngleSum;
  /// rho_ij = theta_j(ji) + pi - theta_i(ij) of each edge in its direction: a vector at angle phi
  /// in i arrives at angle phi + rho in j.
  LargeArray<double> Rotation;
  /// Curvature of each triangle, the sum of its scaled corner angles - pi; n times it is the
  /// holonomy Omega of a field of degree n.
  LargeArray<double> Curvature;

  /// Sets Rotation and Curvature from the angles.
  void Connect(const TriangleMesh& mesh);

  /// Scaled angle of the corner at the tail of a half-edge.
  double CornerAngle(const TriangleMesh& mesh, Index h) const
  {
    const Index next = mesh.NextOutgoing(h);
    const double end = next == None ? this->AngleSum[mesh.Tail(h)] : this->EdgeAngle[next];
    const double angle = end - this->EdgeAngle[h];
    // The next edge may be the reference edge.
    return angle > 0.0 ? angle : angle + 2.0 * Pi;
  }

  /// rho along a half-edge.
  double RotationAlong(const TriangleMesh& mesh, Index h) const
  {
    const double rho = this->Rotation[mesh.Edge(h)];
    return mesh.GivesDirection(h) ? rho : -rho;
  }
};
}

#endif
