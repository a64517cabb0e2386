// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldMatching_h
#define DirectionFields_FieldMatching_h

#include "Geometry/IntrinsicGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A chart at every vertex, in which direction 0 of the field is the real axis, and the rotations
/// between the charts at the two ends of every edge: the matching of the field.
struct FieldMatching
{
  /// @param section of the degree, over the vertices; where it vanishes any direction will do
  FieldMatching(const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& section);

  int Degree;
  /// Angle of direction 0 at each vertex, in (-pi / n, pi / n].
  std::vector<double> Angle;
  /// m of each edge i -> j in its direction, 0 ... n - 1: a direction z in the chart of j is zeta^m
  /// z in the chart of i.
  std::vector<int> Matching;
  /// The remaining difference between matched directions, radians: the angle of the edge in the
  /// chart of i minus 2 pi m / n minus its angle in the chart of j. At most pi / n in absolute
  /// value.
  std::vector<double> Remainder;
  /// Singularity index of each triangle, as SingularityIndices: minus the sum of the matchings
  /// around it, modulo n.
  std::vector<int> SingularityIndex;

  /// m and the remainder along a half-edge, in either direction.
  int MatchingAlong(const TriangleMesh& mesh, Index h) const
  {
    const int m = this->Matching[mesh.Edge(h)];
    return mesh.GivesDirection(h) || m == 0 ? m : this->Degree - m;
  }
  double RemainderAlong(const TriangleMesh& mesh, Index h) const
  {
    const double r = this->Remainder[mesh.Edge(h)];
    return mesh.GivesDirection(h) ? r : -r;
  }
  /// The angle of a half-edge in the chart of its tail and in that of its head.
  double AngleAtTail(const IntrinsicGeometry& geometry, Index h) const
  {
    return geometry.Transport.EdgeAngle[h] - this->Angle[geometry.Mesh.Tail(h)];
  }
  double AngleAtHead(const IntrinsicGeometry& geometry, Index h) const
  {
    return ReverseAngle(geometry, h) + Pi - this->Angle[geometry.Mesh.Head(h)];
  }
  /// The scaled angle of the reverse of a half-edge, also on the boundary.
  static double ReverseAngle(const IntrinsicGeometry& geometry, Index h)
  {
    const Index twin = geometry.Mesh.Twin(h);
    return twin != None ? geometry.Transport.EdgeAngle[twin]
                        : geometry.Transport.AngleSum[geometry.Mesh.Head(h)];
  }
};
}

#endif
