// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ExtractionMesh_h
#define DirectionFields_ExtractionMesh_h

#include "Parametrization/IntegerGridMap.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A triangle mesh with grid coordinates at every corner. It is changed by local operations that
/// keep its topology: vertices are inserted, edges flipped, vertices removed. Every triangle has a
/// chart of its own; transitions lead from one to the next, and every operation carries them along
/// exactly.
///
/// Half-edge 3 t + c runs from corner c of triangle t to the next. Removed triangles have the
/// corners None.
class ExtractionMesh
{
public:
  ExtractionMesh(const CutMesh& mesh, const IntegerGridMap& map);

  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  const IntegerGrid& GetPlane() const { return this->Plane; }
  Index GetNumberOfTriangles() const { return static_cast<Index>(this->Corners.size() / 3); }
  Index GetNumberOfVertices() const { return static_cast<Index>(this->Positions.size()); }
  bool IsTriangle(Index t) const { return this->Corners[3 * t] != None; }
  bool IsVertex(Index v) const { return this->Outgoings[v] != None; }
  Index Tail(Index h) const { return this->Corners[h]; }
  Index Head(Index h) const { return this->Corners[Next(h)]; }
  Index Twin(Index h) const { return this->Twins[h]; }
  bool IsFeature(Index h) const { return this->Features[h] != 0; }
  /// The number of the feature that a half-edge is part of, or 0.
  Index Feature(Index h) const { return this->Features[h]; }
  /// The coordinates of the tail of a half-edge in the chart of its triangle.
  const GridPoint& Place(Index h) const { return this->Places[h]; }
  /// From the chart on the other side of a half-edge.
  const Transition& Across(Index h) const { return this->Acrosses[h]; }
  const Vector3& Position(Index v) const { return this->Positions[v]; }
  bool IsPositive(Index t) const
  {
    return IntegerGrid::Orientation(
             this->Places[3 * t], this->Places[3 * t + 1], this->Places[3 * t + 2]) > 0;
  }

  /// The role of a vertex in the extracted mesh.
  struct Role
  {
    /// It stays as a vertex: a grid point.
    bool IsKept = false;
    /// The charts around it do not close up, or it stands for a singularity.
    bool IsCone = false;
    /// Features end, meet or turn here.
    bool IsCorner = false;
  };
  const Role& GetRole(Index v) const { return this->Roles[v]; }
  void SetKept(Index v, bool isKept) { this->Roles[v].IsKept = isKept; }
  void SetCone(Index v, bool isCone) { this->Roles[v].IsCone = isCone; }

  /// The outgoing half-edges of a vertex counter-clockwise; on the boundary from its first one on.
  /// Returns whether it is on the boundary.
  bool GetStar(Index v, std::vector<Index>& star) const;
  bool IsBoundary(Index v) const;
  bool AreJoined(Index v, Index w) const;

  /// The triangles around a vertex laid out in the chart of the first one.
  struct Layout
  {
    std::vector<Index> Star;
    /// The neighbours counter-clockwise, and their coordinates. On the boundary there is one more
    /// than triangles.
    std::vector<Index> Ring;
    std::vector<GridPoint> Places;
    /// From the chart of each triangle.
    std::vector<Transition> Charts;
    bool IsOpen = false;
    /// The charts close up around the vertex.
    bool IsFlat = true;
    Index Positive = 0;
  };
  void LayOut(Index v, Layout& layout) const;

  /// Replaces an interior edge by the other diagonal: h then runs from the corner opposite of its
  /// twin to its own opposite corner.
  void Flip(Index h);
  /// Puts a vertex on an edge, at coordinates in the chart of the half-edge's triangle. Returns it.
  Index SplitEdge(Index h, GridPoint place, const Vector3& position);
  /// Puts a vertex inside a triangle.
  Index SplitTriangle(Index t, GridPoint place, const Vector3& position);
  /// Replaces the triangles around a vertex by these, whose corners are places in the ring,
  /// counter-clockwise. One edge between two places of the ring, unless None, becomes part of the
  /// feature. On the boundary the new boundary edge joins the last place and the first one.
  void RemoveVertex(Index v, const Layout& layout, const std::vector<Triangle>& triangles,
    std::array<Index, 2> ends, Index feature, std::vector<Index>& changed);
  /// Merges the tail of a half-edge into its head, which has the same coordinates and stays.
  void Collapse(Index h);
  /// Whether the mesh stays one of simple triangles then.
  bool MayCollapse(Index h) const;

  /// V - E + F
  Index EulerCharacteristic() const;

private:
  /// The outside of an edge of a ring, seen from the chart of the ring.
  struct RingSide
  {
    Index Twin;
    Transition Across;
    Index Feature;
  };
  void Link(Index h, Index twin, const Transition& across);
  Index AddTriangle();

  IntegerGrid Plane;
  std::vector<Index> Corners;
  std::vector<Index> Twins;
  std::vector<GridPoint> Places;
  std::vector<Transition> Acrosses;
  std::vector<Index> Features;
  std::vector<Index> Outgoings;
  std::vector<Vector3> Positions;
  std::vector<Role> Roles;
};
}

#endif
