// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CutGraph_h
#define DirectionFields_CutGraph_h

#include "Charts/FeatureLines.h"

#include <vector>

namespace DirectionFields::Internal
{
/// zeta^Turn T, where T is the Variable-th unknown jump.
struct Jump
{
  Index Variable;
  int Turn;
};

/// Where the grid coordinates of a component jump from one chart to the next. The coordinates of a
/// map agree across an edge up to a rotation, which the matching gives, and an unknown translation
/// of the integer grid. The choice of charts makes all but a few of the translations 0: the
/// exceptions lie along paths over the triangles that connect the cones, the frameless vertices and
/// the loops of the boundary with each other, and go once around each handle. Each path has one
/// unknown T, which is carried along such that every regular triangle closes up for any value of T.
class CutGraph
{
public:
  /// @param isFrameless of each vertex of the mesh; no two neighbours may be
  CutGraph(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component,
    const FieldMatching& matching, const FeatureLines& features,
    const std::vector<char>& isFrameless);

  /// The jumps of an edge in its direction: the coordinates in the chart of its tail are zeta^m
  /// times the coordinates in the chart of its head, plus these.
  const std::vector<Jump>& At(Index edge) const { return this->Jumps[edge - this->FirstEdge]; }
  Index GetNumberOfVariables() const { return this->NumberOfVariables; }
  /// How many of these go around handles: twice the genus.
  Index GetNumberOfLoops() const { return this->NumberOfLoops; }
  /// A regular triangle in which paths end as in a cone, if there is nothing else to end in; else
  /// None. The sum of their jumps there has to vanish.
  Index GetSeed() const { return this->Seed; }

private:
  struct Search;
  /// Adds an unknown along the path from the source of a triangle to that of the triangle across an
  /// edge.
  void AddPath(const Search& search, Index edge);

  const IntrinsicGeometry& Geometry;
  const FieldMatching& Matching;
  Index FirstEdge;
  std::vector<std::vector<Jump>> Jumps;
  Index NumberOfVariables = 0;
  Index NumberOfLoops = 0;
  Index Seed = None;
};
}

#endif
