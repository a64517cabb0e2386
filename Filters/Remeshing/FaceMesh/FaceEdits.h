// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceEdits_h
#define DirectionFields_FaceEdits_h

#include "FaceMesh/MovableFaces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Local edits of quads, and of the few triangles among them, or of triangles alone, that keep the
/// topology: edges are turned, vertices merged, quads cut. Feature and boundary edges are kept or
/// merged with the next edge of the same line.
class FaceEdits
{
public:
  /// Penalty for a triangle, where a vertex with one face too many or too few has a penalty of 10.
  static constexpr int PerTriangle = 12;

  /// The penalty for the valence of a vertex.
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
  /// @param places  tell which vertices lines need to stay close; null for none
  /// @param degree  4 where faces are to be quads, 6 where all are triangles and stay so
  FaceEdits(VertexStars& faces, std::vector<Rule> rules, const MovableFaces* places = nullptr,
    int degree = 4);

  /// One edit: two faces with a common edge whose polygon is cut along another diagonal, a vertex
  /// that is merged with another one along an edge or the diagonal of a quad, or a quad that is cut
  /// into two triangles.
  struct Edit
  {
    /// Faces, or vertices: the first one goes. The second face is None where a quad is cut.
    Index First;
    Index Second;
    /// The number of the diagonal along which faces are cut; None for merged vertices.
    Index Diagonal;
  };
  /// The edits of faces at a vertex.
  std::vector<Edit> Find(Index v) const;
  /// Edits that make triangles or shorten lines, for the sake of bad faces: a vertex is merged with
  /// the next one of its line or, if it is free, with any neighbour, and quads are cut.
  std::vector<Edit> FindForBadFaces(Index v) const;
  /// By how much an edit makes the irregularity grow: that of all vertices, and of triangles.
  int GrowthBy(const Edit& edit) const;
  /// Applies an edit. Returns false, and changes nothing, if the result would not be a manifold
  /// mesh.
  bool Do(const Edit& edit);

  /// Penalty for a vertex's valence if `more` faces were added; 0 at the wanted valence.
  int Irregularity(Index v, Index more = 0) const;
  /// Whether the faces at a vertex are as many as a mesh needs.
  bool HasEnoughFaces(Index v) const;

private:
  bool Exchange(const Edit& edit, const std::vector<Index>& polygon);
  bool Cut(Index f, Index diagonal);
  bool IsAlongLine(Index goes, Index stays) const;
  bool Merge(Index goes, Index stays, const std::vector<Index>& around);
  /// The polygon of two faces with one common edge, whose other vertices differ, from an end of
  /// that edge on; else empty.
  std::vector<Index> PolygonOf(Index f, Index g) const;
  int Growth(Index v, Index more) const;

  VertexStars& Cells;
  std::vector<Rule> Rules;
  const MovableFaces* Places;
  bool AreTriangles;
};
}

#endif
