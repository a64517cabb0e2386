// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SplittableMesh_h
#define DirectionFields_SplittableMesh_h

#include "Surface.h"

#include <array>
#include <functional>
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
  std::vector<Index> At(Index p) const;
  /// One of them; None for none.
  Index FirstAt(Index p) const { return this->First[p] == None ? None : this->First[p] / 3; }
  /// The triangles at an edge. Takes time by the fewer of those at its ends.
  std::vector<Index> Between(Index p, Index q) const;
  bool AreJoined(Index p, Index q) const { return !this->Between(p, q).empty(); }

  /// Puts a point on an edge, and joins it with the corners across. Returns its number.
  Index SplitEdge(Index p, Index q, const Vector3& place);
  /// Puts a point into a triangle, and joins it with the corners. Returns its number.
  Index SplitInside(Index t, const Vector3& place);

  /// Turns edges across from a point that was put in, and from there on, until the parts of each
  /// triangle of the surface are Delaunay there again (C. L. Lawson: Software for C1 surface
  /// interpolation, 1977): else they became slivers, and walks through them long. None that starts
  /// at the point is turned. Takes time by how many are, which are few in the mean.
  /// @param isFixed whether an edge between two parts of one triangle stays all the same
  void TurnEdges(Index p, const std::function<bool(Index, Index)>& isFixed);

private:
  /// The triangle beside another one at an edge whose turn makes them better; None for none.
  Index WorseAcross(Index t, Index p, Index q) const;
  void Turn(Index t, Index other, Index p, Index q);

  bool Has(Index t, Index p) const;
  /// Puts corners of triangles into the lists of their points, and takes them out.
  void Append(Index corner);
  void Remove(Index corner);
  Index CornerAt(Index t, Index p) const;
  Index AddPoint(const Vector3& place);
  /// Adds a part of the triangle that another one is a part of.
  void AddPart(Index of, const Triangle& corners);

  std::vector<Vector3> Points;
  std::vector<Triangle> Triangles;
  std::vector<Index> Parents;
  std::vector<std::vector<Index>> PartsOf;
  /// The corners at each point are a list, 3 * t + c each: a corner of a large triangle may come to
  /// have as many as there are points in it, and none of the steps here may take time by that.
  std::vector<Index> First;
  std::vector<Index> Last;
  std::vector<Index> Next;
  std::vector<Index> Previous;
};
}

#endif
