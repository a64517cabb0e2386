// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_UnitLengthProblem_h
#define DirectionFields_UnitLengthProblem_h

#include "Geometry/IntrinsicGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The sections u of modulus 1 over one component, and the energy to be minimized among them:
///
/// E(u) = u^* K u + 2 sum over i of (|p_i| - Re conj(p_i) u_i),
///
/// where K is the matrix of UnitEnergyMatrix and p draws u to a guidance: its phase is that of the
/// guidance, its modulus a weight. E has no unit. All arrays are over the vertices of the
/// component.
struct UnitLengthProblem
{
  /// The triangulation that K is of.
  const IntrinsicGeometry& Geometry;
  /// The surface's own triangulation, which knows the mirror images of a double cover.
  const IntrinsicGeometry& Surface;
  const TriangleMesh::Component& Component;
  int Degree;
  /// K
  const SparseMatrix& Matrix;
  /// The mass matrix, which has the same pattern and tells the transport (see Operators).
  const SparseMatrix& Mass;
  /// p; empty for none.
  ComplexVector Pull;
  /// 1 at the vertices whose values are given; empty where all are free and none is drawn to a
  /// value of its own, so that the start is about as good as the smoothest field.
  std::vector<char> IsGiven;

  bool IsFree(Index v) const { return this->IsGiven.empty() || this->IsGiven[v] == 0; }
  /// Whether a corner of a triangle of the geometry has a given value.
  bool IsAtGiven(Index t) const
  {
    bool isGiven = false;
    for (Index h = 3 * t; !this->IsGiven.empty() && h < 3 * t + 3; ++h)
    {
      isGiven = isGiven || !this->IsFree(this->Geometry.Mesh.Tail(h) - this->Component.FirstVertex);
    }
    return isGiven;
  }
  Index Rows() const { return this->Component.Vertices(); }
  /// Half of the gradient of E without the bound |u| = 1: K u - p.
  ComplexVector Gradient(const ComplexVector& u) const;
  /// E of a section from that gradient.
  double Energy(const ComplexVector& u, const ComplexVector& gradient) const;
  /// E
  double Energy(const ComplexVector& u) const { return this->Energy(u, this->Gradient(u)); }
};

/// The mean of two energies of sections of modulus 1: the smoothness energy, which integrates
/// sections that are linear in the triangles and fade in those of much curvature; and the sum over
/// the edges of w |u_j - r_ij u_i|^2, where w is the cotangent weight or 0, whichever is larger,
/// which does not see how they fade. Where triangles are even and flat the two are the same.
/// @param energy     the smoothness energy, which gives the pattern
/// @param energyBias s; on the boundary both energies have it, elsewhere sections of modulus 1 do
///                   not feel it
SparseMatrix UnitEnergyMatrix(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, double energyBias,
  const SparseMatrix& energy);

/// Scales each value to modulus 1, in place. Where a value vanishes the other section's is taken,
/// or 1 where that vanishes, too.
void MakeUnit(ComplexVector& u, const ComplexVector* other = nullptr);
}

#endif
