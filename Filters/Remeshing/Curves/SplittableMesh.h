// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SplittableMesh_h
#define DirectionFields_SplittableMesh_h

#include "Surface.h"

#include <array>
#include <vector>

namespace DirectionFields::Internal
{
/// Triangles that can be split where a point is wanted. Any number of them may meet at an edge.
class SplittableMesh
{
public:
  /// Triangles with a corner twice, or a point that is not there, take no part.
  explicit SplittableMesh(const Surface& surface);

  const std::vector<Vector3>& GetPoints() const { return this->Points; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// The triangle of the surface that a triangle is a part of.
  Index Parent(Index t) const { return this->Parents[t]; }
  /// The parts of a triangle of the surface.
  const std::vector<Index>& Parts(Index parent) const { return this->PartsOf[parent]; }
  /// The triangles at a point.
  const std::vector<Index>& At(Index p) const { return this->Stars[p]; }
  bool AreJoined(Index p, Index q) const { return !this->Between(p, q).empty(); }

  /// Puts a point on an edge, and joins it with the corners across. Returns its number.
  Index SplitEdge(Index p, Index q, const Vector3& place);
  /// Puts a point into a triangle, and joins it with the corners. Returns its number.
  Index SplitInside(Index t, const Vector3& place);

private:
  /// The triangles at an edge.
  std::vector<Index> Between(Index p, Index q) const;
  Index AddPoint(const Vector3& place);
  /// Adds a part of the triangle that another one is a part of.
  void AddPart(Index of, const Triangle& corners);

  std::vector<Vector3> Points;
  std::vector<Triangle> Triangles;
  std::vector<Index> Parents;
  std::vector<std::vector<Index>> PartsOf;
  std::vector<std::vector<Index>> Stars;
};
}

#endif
