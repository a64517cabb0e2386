// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Seams_h
#define DirectionFields_Seams_h

#include "Extraction/MeshExtraction.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where sheets of a surface meet although its mesh has a boundary there: along edges of more than
/// two triangles, and where a one-sided surface was cut open. The sheets get their faces one by
/// one; along the seams they are given vertices at the same places, which are then merged.
class Seams
{
public:
  /// Takes time linear in the mesh, and sorts the edges of the seams.
  /// @param original of each point the one that it is a copy of, or itself
  Seams(const TriangleMesh& mesh, const std::vector<Index>& original);

  /// Vertices of the mesh where seams end, meet or begin. Faces are to have a vertex there.
  std::vector<Index> GetEnds() const;
  /// V - E + F of the mesh, the sheets joined.
  int GetEulerCharacteristic() const { return this->EulerCharacteristic; }

  /// Adds vertices on the sides of seams that have fewer of them than another side, and moves the
  /// others to that side's places. A quad with one more vertex becomes a quad and a triangle.
  void Equalize(std::vector<ExtractedMesh>& components) const;
  /// The vertex that replaces each one, the vertices of all components being numbered
  /// consecutively. Counts the seams that stay open: where both sides have so few faces that they
  /// would become one.
  std::vector<Index> Joined(const std::vector<ExtractedMesh>& components, Index& open) const;

private:
  /// A side of a seam: the boundary of a sheet from one vertex of the mesh to another one.
  struct Side
  {
    Index Start;
    Index End;
    /// The boundary, along which the sheet lies to the left, runs from the end to the start.
    bool IsReversed;
  };
  struct Seam
  {
    std::vector<Side> Sides;
  };
  class Finder;
  class Sheets;

  std::vector<Seam> All;
  int EulerCharacteristic = 0;
};
}

#endif
