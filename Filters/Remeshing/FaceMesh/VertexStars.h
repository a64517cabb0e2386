// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VertexStars_h
#define DirectionFields_VertexStars_h

#include "FaceMesh/FaceMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Faces and which of them are at each vertex, while they are changed. Numbers stay: a face that is taken away has
/// None for its first corner, until Compressed.
class VertexStars
{
public:
  /// @param lines edges that are parts of features or of the boundary
  VertexStars(
    const Faces& faces, Index vertices, const std::vector<FaceMesh::LineEdge>& lines = {});

  Index GetNumberOfFaces() const { return static_cast<Index>(this->Cells.Corners.size()); }
  Index GetNumberOfVertices() const { return static_cast<Index>(this->Stars.size()); }
  bool IsFace(Index f) const { return this->Cells.Corners[f][0] != None; }
  const Faces::Face& Face(Index f) const { return this->Cells.Corners[f]; }
  /// The faces at a vertex, ascending.
  const std::vector<Index>& At(Index v) const { return this->Stars[v]; }

  /// The vertices that edges lead to from a vertex, ascending.
  std::vector<Index> Neighbours(Index v) const;
  bool AreJoined(Index v, Index w) const;
  /// The face at v's and w's edge besides f, or None.
  Index Across(Index f, Index v, Index w) const;

  /// Where the edges of lines lead to from a vertex, ascending.
  const std::vector<Index>& LineEnds(Index v) const { return this->Lines[v]; }
  bool IsLineEdge(Index v, Index w) const;

  /// A face as it was before a change. Without a face, a vertex of a line that has become one with the second corner,
  /// the line having gone on to the third.
  struct Change
  {
    Index Face;
    Faces::Face Corners;
    char IsRegular;
  };
  /// What has been changed, in the order of time.
  const std::vector<Change>& GetChanges() const { return this->Changes; }
  /// The corners, ascending, of what was changed, as it was and as it is.
  std::vector<Index> TouchedSince(std::size_t changes) const;
  /// Puts other corners in the place of those of a face, which is no cell of the lattice from then on.
  void Set(Index f, const Faces::Face& corners);
  /// Adds a face, which is no cell of the lattice.
  void Add(const Faces::Face& corners);
  /// Lets a line that leads through a vertex go past it: from one of the two next vertices, which is to take its place,
  /// straight to the other.
  void ShortenLine(Index goes, Index stays);
  /// Takes changes back until so many are left.
  void UndoTo(std::size_t changes);
  /// The faces that are there, in the same order.
  Faces Compressed() const;

private:
  void Put(Index f, const Faces::Face& corners);
  static void Insert(std::vector<Index>& sorted, Index item);
  static void Erase(std::vector<Index>& sorted, Index item);

  Faces Cells;
  std::vector<std::vector<Index>> Stars;
  std::vector<std::vector<Index>> Lines;
  std::vector<Change> Changes;
};
}

#endif
