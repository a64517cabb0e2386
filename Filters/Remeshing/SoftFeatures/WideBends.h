// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WideBends_h
#define DirectionFields_WideBends_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// How a surface bends around an edge, radians.
struct WideBend
{
  /// Between its two sides.
  double Across = 0.0;
  /// From near the edge to farther away, the mean of both sides.
  double Beside = 0.0;
};

/// The bends around edges, of the triangles within a few steps from them. Noise cancels out there:
/// the area vectors of a piece of surface sum up to what its boundary says alone.
class WideBends
{
public:
  explicit WideBends(const SurfaceGeometry& geometry);

  /// Takes a constant time.
  const WideBend& At(Index e);

private:
  struct Piece
  {
    Vector3 Middle;
    /// As long as twice the area.
    Vector3 Area;
    double Away = 0.0;
  };
  struct Halves;

  WideBend Measure(Index e);
  void Collect(Index e);
  void CollectAt(Index v, Index e, std::vector<Index>& next);

  const TriangleMesh& Mesh;
  const std::vector<Vector3>& Positions;
  std::vector<WideBend> Known;
  std::vector<char> IsKnown;
  /// The edge around which each was seen last.
  std::vector<Index> SeenTriangle;
  std::vector<Index> SeenVertex;
  std::vector<Piece> Pieces;
};
}

#endif
