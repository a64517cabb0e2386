// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CutMesh_h
#define DirectionFields_CutMesh_h

#include "Charts/CutGraph.h"
#include "Charts/IntegerGrid.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// z -> zeta^Turn z + the sum of the jumps: a transition whose jumps are not known yet.
struct SymbolicTransition
{
  int Turn = 0;
  std::vector<Jump> Jumps;

  /// First t, then s.
  static SymbolicTransition Composed(
    const SymbolicTransition& s, const SymbolicTransition& t, int degree);
  SymbolicTransition Inverse(int degree) const;
  /// Jumps that cancel are taken out, the others are in the order of their variables.
  void Simplify(int degree);
  bool IsIdentity() const { return this->Turn == 0 && this->Jumps.empty(); }
};

/// A component with a vertex in the middle of each cone, and a chart for every triangle: everything
/// needed to set up the map. Vertices are the component's, counted from its first one, then the
/// cones'.
struct CutMesh
{
  /// @param section of the field, over the vertices of the mesh; places the cones
  CutMesh(const SurfaceGeometry& geometry, const TriangleMesh::Component& component,
    const FieldMatching& matching, const FeatureLines& features,
    const std::vector<char>& isFrameless, const CutGraph& graph,
    const std::vector<Complex>& section);

  struct MapTriangle
  {
    Triangle Vertex;
    /// From the chart of each corner's vertex to that of the triangle.
    std::array<SymbolicTransition, 3> Corner;
    /// Edge c runs from corner c to the next one. Target: the wanted increase of the coordinates
    /// along it in the triangle's chart, in the input's unit of length. Weight: half the cotangent
    /// of the opposite angle. Twin: the half-edge on the other side, or None. Feature: the number
    /// of its feature, from 1 on, or 0.
    std::array<Complex, 3> Target;
    std::array<double, 3> Weight;
    std::array<Index, 3> Twin;
    std::array<Index, 3> Feature;
  };

  /// A vertex without a frame of its own: its chart is that of the first triangle around it.
  struct Cone
  {
    Index Vertex;
    /// From the chart of the first triangle once around the cone and back to it: the coordinates of
    /// the cone are its fixed point.
    SymbolicTransition Holonomy;
  };

  /// A feature edge: its two ends have the same second coordinate once zeta^-Axis is applied in the
  /// chart of the triangle.
  struct IsolineEdge
  {
    Index Triangle;
    int Corner;
    int Axis;
    /// The edge of the surface that it is.
    Index Edge;
  };

  int Degree;
  std::vector<MapTriangle> Triangles;
  std::vector<Vector3> Positions;
  std::vector<Cone> Cones;
  std::vector<IsolineEdge> Isolines;
  /// The unknown jumps.
  Index NumberOfJumps;
  /// The singularity index of each vertex that is a cone, 0 elsewhere; whether features leave a
  /// vertex without a frame.
  std::vector<int> ConeIndex;
  std::vector<char> IsCorner;
  /// Vertices with one feature, or more than two, or with features of different axes.
  std::vector<char> IsChainEnd;

private:
  struct Builder;
};
}

#endif
