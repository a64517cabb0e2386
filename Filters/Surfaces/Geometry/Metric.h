// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Metric_h
#define DirectionFields_Metric_h

#include "Mesh/TriangleMesh.h"
#include "Support/LargeArray.h"

#include <vector>

namespace DirectionFields
{
/// Area of a triangle of these edge lengths; 0 where there is none.
double TriangleArea(const std::array<double, 3>& length);
/// Angles of a triangle's corners, radians. length[c] belongs to the edge from corner c to c + 1.
std::array<double, 3> TriangleAngles(const std::array<double, 3>& length, double area);

/// Intrinsic geometry of a mesh: edge lengths, and the corner angles and areas that follow from
/// them. Everything else is computed from these.
///
/// Lengths are in units of the mean edge length of their component, so that nothing depends on the
/// scale of the input. Where a triangle is (nearly) without area its shortest edge is lengthened
/// until the triangle inequality holds by a millionth of its longest edge (mollification after
/// Sharp and Crane: A Laplacian for Nonmanifold Triangle Meshes, 2020, but locally).
struct Metric
{
  /// Throws MeshError where coordinates are so large that their differences overflow.
  /// @param positions of the vertices
  /// @param sizes     at each vertex, above 0: lengths count in units of the size there, those of
  ///                  edges in units of the geometric mean at their ends, which makes a metric
  ///                  conformal to the surface's own; empty for the same unit everywhere
  Metric(const TriangleMesh& mesh, const std::vector<Vector3>& positions,
    const std::vector<double>& sizes = {});

  /// Squared length of each edge.
  LargeArray<double> SquaredLength;
  /// Area of each triangle.
  LargeArray<double> Area;
  /// Mean edge length of each component in the input's unit.
  std::vector<double> Unit;
  /// Area of each component, in Unit^2; of one side of a cover.
  std::vector<double> ComponentArea;
  /// Triangles whose edges had to be lengthened.
  Index DegenerateTriangles = 0;

  /// Changes the unit of a component.
  /// @param unit positive, in the input's unit
  void SetUnit(const TriangleMesh& mesh, Index component, double unit);

  /// Angles of the corners at the tails of a triangle's half-edges, radians, in (0, pi).
  std::array<double, 3> CornerAngles(const TriangleMesh& mesh, Index triangle) const;
  double CornerAngle(const TriangleMesh& mesh, Index h) const
  {
    return this->CornerAngles(mesh, h / 3)[h % 3];
  }

  /// Half the sum of the cotangents of the corners opposite of a half-edge and its twin, if it has
  /// one: the weight of the edge in the Dirichlet energy of linear functions.
  double EdgeWeight(const TriangleMesh& mesh, Index h) const
  {
    double weight = 0.0;
    for (const Index side : { h, mesh.Twin(h) })
    {
      if (side != None)
      {
        const double across = this->SquaredLength[mesh.Edge(TriangleMesh::Next(side))] +
          this->SquaredLength[mesh.Edge(TriangleMesh::Previous(side))] -
          this->SquaredLength[mesh.Edge(side)];
        weight += across / (8.0 * this->Area[side / 3]);
      }
    }
    return weight;
  }

private:
  Index Measure(const TriangleMesh& mesh, const std::vector<Vector3>& positions,
    const std::vector<double>& sizes, Index c);
};
}

#endif
