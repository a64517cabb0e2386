// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MovablePlaces_h
#define DirectionFields_MovablePlaces_h

#include "Charts/CutMesh.h"
#include "Charts/IntegerGrid.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The places of a map's vertices, and how those may move that are no grid points.
class MovablePlaces
{
public:
  /// All must live as long.
  /// @param own from the chart of each corner's vertex to the chart of its triangle
  /// @param isPoint not 0 at vertices that stay
  /// @param perLength 1 / h of each vertex, h the wanted length of an edge of the grid
  /// @param places of the vertices in their own charts
  MovablePlaces(const CutMesh& mesh, const std::vector<Transition>& own,
    const std::vector<char>& isPoint, const std::vector<double>& perLength,
    std::vector<GridPoint>& places);

  /// The triangles with a corner at a vertex, ascending.
  struct Triangles
  {
    const Index* begin() const { return this->First; }
    const Index* end() const { return this->Last; }
    Index operator[](Index k) const { return this->First[k]; }
    Index size() const { return static_cast<Index>(this->Last - this->First); }

    const Index* First;
    const Index* Last;
  };
  Triangles TrianglesAt(Index v) const
  {
    return { this->Around.data() + this->Begin[v], this->Around.data() + this->Begin[v + 1] };
  }

  /// In how many directions a vertex may move: in both, along its feature, or not.
  int GetFreedom(Index v) const { return this->Freedom[v]; }
  /// The direction of the first coordinate of a move, in the chart of the vertex.
  Complex GetDirection(Index v) const { return this->Plane.Root(this->Axis[v]); }
  /// Moves a vertex by coordinates in that direction and, where it may, across.
  void Move(Index v, double along, double across);
  /// Moves a vertex to a place in a chart.
  /// @param toChart from the chart of the vertex
  void MoveTo(Index v, const Complex& place, const Transition& toChart);

  const Transition& FromVertex(Index t, int c) const { return this->Own[3 * t + c]; }
  /// The place of a vertex in a chart.
  Complex PlaceIn(const Transition& toChart, Index v) const
  {
    return this->Plane.Place(this->Plane.Apply(toChart, this->Places[v]));
  }
  /// The place of a corner in the chart of its triangle.
  Complex Corner(Index t, int c) const
  {
    return this->PlaceIn(this->FromVertex(t, c), this->Mesh.Triangles[t].Vertex[c]);
  }
  GridPoint CornerPoint(Index t, int c) const
  {
    return this->Plane.Apply(
      this->FromVertex(t, c), this->Places[this->Mesh.Triangles[t].Vertex[c]]);
  }
  /// Whether a triangle is turned over, or has no area.
  bool IsFlipped(Index t) const;

  /// The area of a triangle in the map, negative where it is flipped, and in space, in squares of
  /// the grid's edges.
  double AreaInMap(Index t) const;
  double AreaInSpace(Index t) const;
  /// Whether a triangle has no area wherever those of its corners go that may move: two that stay
  /// are in one place, or all are on a line along which they move.
  bool StaysFlat(Index t) const;

  /// Whether a vertex is a cone in the middle of a triangle, which became three around it: it is
  /// the first corner of each.
  bool IsInTriangle(Index v) const { return v >= this->FirstInTriangle; }
  /// The angle that the map is to have around such a cone.
  double WantedAngle(Index cone) const;
  /// Whether the map goes around a vertex by the angle that it is to have there. Without flipped
  /// triangles it can still go around twice.
  bool IsSurrounded(Index v) const;

  const CutMesh& Mesh;
  const IntegerGrid Plane;
  const std::vector<double>& PerLength;
  std::vector<GridPoint>& Places;

private:
  void LimitMoves(const std::vector<char>& isPoint);
  void FindAngles();
  double AngleAround(Index v) const;

  const std::vector<Transition>& Own;
  Index FirstInTriangle;
  std::vector<char> Freedom;
  std::vector<char> Axis;
  /// What a map has around each vertex that is no cone in a triangle; 0 where that may be any
  /// angle, without a frame and at corners of the boundary.
  std::vector<double> Angle;
  std::vector<Index> Begin;
  std::vector<Index> Around;
};
}

#endif
