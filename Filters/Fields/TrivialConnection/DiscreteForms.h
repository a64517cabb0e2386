// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DiscreteForms_h
#define DirectionFields_DiscreteForms_h

#include "Geometry/IntrinsicGeometry.h"
#include "Support/LargeArray.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A number for each edge of a component in the edge's direction: how much something turns or rises
/// along it.
using EdgeForm = LargeArray<double>;

/// Sums and scalar products of the edge forms of one component (discrete exterior calculus, A.
/// Hirani 2003). The weight of an edge is half the sum of the cotangents of the angles opposite of
/// it.
class DiscreteForms
{
public:
  /// Both must outlive this.
  DiscreteForms(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component);

  const TriangleMesh& GetMesh() const { return this->Geometry.Mesh; }
  const TriangleMesh::Component& GetComponent() const { return this->Component; }

  /// 1 where a half-edge runs in the direction of its edge, else -1.
  int Sign(Index h) const { return this->Geometry.Mesh.GivesDirection(h) ? 1 : -1; }
  Index LocalEdge(Index h) const { return this->Geometry.Mesh.Edge(h) - this->Component.FirstEdge; }
  Index LocalTail(Index h) const
  {
    return this->Geometry.Mesh.Tail(h) - this->Component.FirstVertex;
  }
  Index LocalHead(Index h) const
  {
    return this->Geometry.Mesh.Head(h) - this->Component.FirstVertex;
  }
  double Along(const EdgeForm& form, Index h) const
  {
    return this->Sign(h) * form[this->LocalEdge(h)];
  }
  /// The sum around a triangle, counter-clockwise.
  double Around(const EdgeForm& form, Index triangle) const
  {
    return this->Along(form, 3 * triangle) + this->Along(form, 3 * triangle + 1) +
      this->Along(form, 3 * triangle + 2);
  }
  double Weight(Index localEdge) const { return this->Weights[localEdge]; }
  /// A third of the area of the triangles at each vertex, in unit^2.
  Eigen::VectorXd VertexAreas() const;
  double Product(const EdgeForm& a, const EdgeForm& b) const;
  /// The inflow of each vertex (minus the codifferential): the sum over its edges of weight times
  /// form, taken in the direction towards the vertex.
  Eigen::VectorXd Inflow(const EdgeForm& form) const;
  /// form -= the rise of the values of the vertices along each edge.
  void SubtractRise(const Eigen::VectorXd& values, EdgeForm& form) const;

private:
  const IntrinsicGeometry& Geometry;
  const TriangleMesh::Component& Component;
  EdgeForm Weights;
};
}

#endif
