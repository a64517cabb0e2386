// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DoubleCover_h
#define DirectionFields_DoubleCover_h

#include "Geometry/IntrinsicGeometry.h"

namespace DirectionFields::Internal
{
/// The sections over a component that cannot be oriented are the symmetric sections over its double
/// cover: those that have the same directions in space on both sides. Seen from the other side a
/// direction at the angle phi is one at -phi, so that the symmetry conjugates; it commutes with the
/// energy and the mass matrix, whatever the bias, for reversing the orientation conjugates both the
/// transport and the sections. Symmetric sections form a real vector space, hence the smallest
/// symmetric eigenvector is determined up to its sign, and has the cover's smallest eigenvalue.
class DoubleCover
{
public:
  /// @param component only used where it is a cover
  DoubleCover(
    const IntrinsicGeometry& geometry, const TriangleMesh::Component& component, int degree);

  /// A value at a vertex of the mesh as seen at the mirror vertex.
  Complex Mirrored(Index vertex, const Complex& value) const;

  /// The mean of a section over the component's vertices and its mirror image: the same on both
  /// sides to the last bit.
  void Symmetrize(ComplexVector& u) const;

  /// Turns a section by that global phase, of at most a quarter turn, which makes it as symmetric
  /// as can be, symmetrizes it, and scales it to u^* M u = 1. An eigenvector stays one.
  void MakeSymmetric(ComplexVector& u, const SparseMatrix& mass) const;

private:
  ComplexVector Mirrored(const ComplexVector& u) const;

  const TriangleMesh& Mesh;
  const Connection& Transport;
  const TriangleMesh::Component& Component;
  int Degree;
};
}

#endif
