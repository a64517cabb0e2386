// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceStars_h
#define DirectionFields_FaceStars_h

#include "Faces/Faces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Faces and which of them are at each vertex, while they are changed. Numbers stay: a face that is taken away has
/// None for its first corner, until Compress.
class FaceStars
{
public:
  FaceStars(const Faces& faces, Index vertices);

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

  /// A face as it was before a change.
  struct Change
  {
    Index Face;
    Faces::Face Corners;
    char IsRegular;
  };
  /// What has been changed, in the order of time.
  const std::vector<Change>& GetChanges() const { return this->Changes; }
  /// Puts other corners in the place of those of a face, which is no cell of the lattice from then on.
  void Set(Index f, const Faces::Face& corners);
  /// Takes changes back until so many are left.
  void UndoTo(std::size_t changes);
  /// The faces that are there, in the same order.
  Faces Compressed() const;

private:
  void Put(Index f, const Faces::Face& corners);

  Faces Cells;
  std::vector<std::vector<Index>> Stars;
  std::vector<Change> Changes;
};
}

#endif
