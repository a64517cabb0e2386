// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceStrip_h
#define DirectionFields_FaceStrip_h

#include "FaceMesh/VertexStars.h"

#include <array>
#include <cstddef>
#include <vector>

namespace DirectionFields::Internal
{
/// Whether a face has an edge in this direction.
bool HasEdge(const Faces::Face& face, Index tail, Index head);

/// A row of faces, each of which shares an edge with the next one: two triangles and the quads
/// between them. The polygon around two triangles and k quads has 2k + 4 corners, which k chords
/// cut into k + 1 quads.
class FaceStrip
{
public:
  /// @param path the faces; edges of lines are not between them
  FaceStrip(const VertexStars& faces, const std::vector<Index>& path);

  /// The vertices around the strip, counter-clockwise, from one that only the first face has.
  const std::vector<Index>& GetPolygon() const { return this->Polygon; }
  /// Whether no vertex is twice in the polygon.
  bool IsSimple() const;

  /// Two corners of the polygon, the first on the right of the strip, the second on its left.
  using Chord = std::array<std::size_t, 2>;
  /// The edges between the faces.
  const std::vector<Chord>& GetEdges() const { return this->Edges; }
  /// Stands for the chord before the first one.
  Chord Whole() const { return { 0, this->Polygon.size() - 1 }; }
  /// The quad between a chord and a later one.
  Faces::Face Between(const Chord& one, const Chord& other) const;
  /// The quad behind the last chord.
  Faces::Face Beyond(const Chord& last) const;

  /// The chords that result if each edge but the last one is moved on to the next vertex on one
  /// side: only the vertices at the ends of the strip get other valences.
  std::vector<Chord> Shifted(bool isRight) const;
  /// Of all chords next to the edges, the ones whose quads are most like rectangles, with no flat
  /// corners on a line; none if edges would cross. Takes time in proportion to the faces.
  std::vector<Chord> Cheapest(const std::vector<Vector3>& points) const;

private:
  std::array<Index, 2> EdgeBetween(Index f, Index g) const;
  void Walk(Index f, Index from, Index to);
  double CostOf(const Faces::Face& quad, const std::vector<Vector3>& points) const;

  const VertexStars& Cells;
  std::vector<Index> Polygon;
  std::vector<Chord> Edges;
};
}

#endif
