// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceEdits_h
#define DirectionFields_FaceEdits_h

#include "FaceMesh/VertexStars.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Local changes of quads, and the few triangles among them, that keep the topology: edges are turned, vertices
/// merged, quads cut. Edges of features and the boundary stay, or become one with the next of theirs.
class FaceEdits
{
public:
  /// What a triangle counts where a vertex with one face too many or too few counts 10.
  static constexpr int PerTriangle = 12;

  /// What of a vertex counts.
  struct Rule
  {
    /// How many faces it should have.
    Index Target = 4;
    /// It may become one with another vertex.
    bool IsFree = true;
    /// It is on a line which it may leave to the next vertices of that.
    bool MayLeaveLine = false;
    /// It is on a feature or the boundary.
    bool IsOnLine = false;
    bool IsBoundary = false;
    /// The number of its faces must not change.
    bool IsLocked = false;
  };
  FaceEdits(VertexStars& faces, std::vector<Rule> rules);

  /// Two faces with a common edge whose polygon is cut another way, or a vertex that becomes one with another one,
  /// to which an edge or the diagonal of a quad leads, or a quad that becomes two triangles.
  struct Edit
  {
    /// Faces, or vertices: the first one goes. The second face is None where a quad is cut.
    Index First;
    Index Second;
    /// Which way of cutting; None for vertices.
    Index Way;
  };
  /// The edits of faces at a vertex.
  std::vector<Edit> Find(Index v) const;
  /// Those that make triangles, or lines shorter, for the sake of bad faces: a vertex becomes one with the next one of
  /// its line or, if it is free, with any neighbour, and quads are cut.
  std::vector<Edit> FindForBadFaces(Index v) const;
  /// By how much an edit makes the irregularity grow: that of all vertices, and of triangles.
  int GrowthBy(const Edit& edit) const;
  /// Does an edit; returns false, and does nothing, where the mesh would not stay one.
  bool Do(const Edit& edit);

  /// What the number of faces at a vertex counts, with so many more; 0 where it is what it should be.
  int Irregularity(Index v, Index more = 0) const;
  /// Whether the faces at a vertex are as many as a mesh needs.
  bool HasEnoughFaces(Index v) const;

private:
  bool Exchange(const Edit& edit, const std::vector<Index>& polygon);
  bool Cut(Index f, Index way);
  bool IsAlongLine(Index goes, Index stays) const;
  bool Merge(Index goes, Index stays, const std::vector<Index>& around);
  /// The polygon of two faces with one common edge, whose other vertices differ, from an end of that on; else empty.
  std::vector<Index> PolygonOf(Index f, Index g) const;
  int Growth(Index v, Index more) const;

  VertexStars& Cells;
  std::vector<Rule> Rules;
};
}

#endif
