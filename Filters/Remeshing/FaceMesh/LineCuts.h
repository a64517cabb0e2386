// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LineCuts_h
#define DirectionFields_LineCuts_h

#include "FaceMesh/FaceMesh.h"

#include <map>
#include <vector>

namespace DirectionFields::Internal
{
/// Splits edges of lines in two, which adds a triangle to each face there: a quad becomes a
/// triangle and a quad, a triangle two triangles.
class LineCuts
{
public:
  /// The mesh is shared, and only this changes it in the meantime.
  explicit LineCuts(FaceMesh& mesh);

  /// An edge of a line and its faces: one at the boundary, more than two where sheets meet.
  struct Wall
  {
    /// Ascending.
    std::array<Index, 2> Ends;
    std::vector<Index> Faces;
    Index Line;
  };

  /// The scaled Jacobian of the worse part of a face, if one of its edges gets a vertex there.
  double QualityOf(Index f, const std::array<Index, 2>& ends, const Vector3& middle) const;
  /// Splits an edge. Faces may have been cut at other edges of theirs before.
  void Cut(const Wall& wall, const Vector3& middle);

private:
  Index PartWith(Index f, const std::array<Index, 2>& ends) const;

  FaceMesh& Mesh;
  /// The edges of lines between two vertices, in the order in which they were found.
  std::multimap<std::array<Index, 2>, std::size_t> Edges;
  /// The parts that were cut off faces.
  std::multimap<Index, Index> PartsOf;
};
}

#endif
