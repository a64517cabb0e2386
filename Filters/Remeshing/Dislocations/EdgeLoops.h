// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EdgeLoops_h
#define DirectionFields_EdgeLoops_h

#include "FaceMesh/FaceMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The edges of a mesh in rows that go on straight where four quads meet. A half-edge 4 f + c leads
/// from corner c of face f to the next one, with the face on its left.
class EdgeLoops
{
public:
  explicit EdgeLoops(const FaceMesh& mesh);

  /// The half-edges of each chain, one after the other. No edge of a line is among them, and each
  /// other edge of a quad is in one chain at most.
  const std::vector<std::vector<Index>>& GetAll() const { return this->Chains; }

  Index Tail(Index halfEdge) const { return this->Mesh.Cells.Corners[halfEdge / 4][halfEdge % 4]; }
  Index Head(Index halfEdge) const { return this->Tail(this->Next(halfEdge)); }
  /// The half-edges after this one and before it in its face.
  Index Next(Index halfEdge) const;
  Index Previous(Index halfEdge) const;
  /// The half-edge of the face beyond, or None where there is none that is wound alike.
  Index Twin(Index halfEdge) const { return this->Twins[halfEdge]; }
  bool IsLine(Index halfEdge) const { return this->AreLines[halfEdge] != 0; }

  /// How many faces are at a vertex.
  Index CountFaces(Index v) const { return this->Counts[v]; }
  /// Whether four quads are around a vertex, and no line or one that goes straight on there.
  bool IsRegular(Index v) const { return this->AreRegular[v] != 0; }
  /// Whether two quads are at a vertex of the boundary where a line goes on.
  bool IsMouth(Index v) const { return this->AreMouths[v] != 0; }
  /// Whether a vertex is inside of the surface, on no line, and may get one more face or lose one.
  bool IsInside(Index v) const { return this->AreInside[v] != 0; }

  /// The half-edges that leave the head of another one straight ahead and to its right, if the head
  /// is regular; the next one leaves it to the left.
  Index Ahead(Index halfEdge) const { return this->Next(this->Twins[this->Next(halfEdge)]); }
  Index ToRight(Index halfEdge) const { return this->Next(this->Twins[this->Ahead(halfEdge)]); }
  /// The vertices on the left and on the right of an end of a half-edge of a chain that is regular
  /// or a mouth.
  std::array<Index, 2> Beside(Index halfEdge, Index v) const;

private:
  void FindTwins();
  void FindVertices();
  void FindChains();

  const FaceMesh& Mesh;
  std::vector<Index> Twins;
  std::vector<char> AreLines;
  std::vector<Index> Counts;
  std::vector<char> AreRegular;
  std::vector<char> AreMouths;
  std::vector<char> AreInside;
  std::vector<std::vector<Index>> Chains;
};
}

#endif
