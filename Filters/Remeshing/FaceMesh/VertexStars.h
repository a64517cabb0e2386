// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VertexStars_h
#define DirectionFields_VertexStars_h

#include "FaceMesh/FaceMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Faces and the faces at each vertex, while they are edited. Numbers stay: a removed face has None
/// for its first corner, until Compressed.
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

  /// The state of a face before a change. Without a face: a vertex of a line that was merged with
  /// the second corner, after which the line continues to the third.
  struct Change
  {
    Index Face;
    Faces::Face Corners;
    char IsRegular;
  };
  /// The changes in the order in which they were made.
  const std::vector<Change>& GetChanges() const { return this->Changes; }
  /// The corners, ascending, of all changed faces, before and after the changes.
  std::vector<Index> TouchedSince(std::size_t changes) const;
  /// Replaces the corners of a face, which then is no cell of the grid any more.
  void Set(Index f, const Faces::Face& corners);
  /// Adds a face, which is no cell of the grid.
  void Add(const Faces::Face& corners);
  /// Takes a vertex out of the line through it: one of its two neighbours on the line replaces it,
  /// and is joined with the other.
  void ShortenLine(Index goes, Index stays);
  /// Undoes changes until this number of them remains.
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
