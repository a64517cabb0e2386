// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Singularities_h
#define DirectionFields_Singularities_h

#include "Geometry/IntrinsicGeometry.h"

namespace DirectionFields
{
/// Index of each triangle of the mesh in units of 1/n:
/// (omega_ij + omega_jk + omega_ki + Omega) / 2pi with omega_ij = arg(u_j / (r_ij u_i)) in [-pi,
/// pi] (KCPS13, section 6.1.2). One omega per edge serves both its triangles, and Omega is not
/// wrapped: on a closed surface the sum is n times the Euler characteristic, exactly, whatever the
/// field.
/// @param degree n
/// @param field  representation vector of each vertex; one that vanishes counts as 1
std::vector<int> SingularityIndices(
  const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& field);

/// The same for the triangles of one component, counted from its first one.
/// @param field representation vector of each vertex of the component, from its first one on
std::vector<int> SingularityIndices(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const Complex* field);

/// omega of each edge of a component in its direction, radians, in [-pi, pi]. Where the values are
/// opposite up to rounding it is positive towards the end that comes last in grids, so that no
/// numbering matters; but on covers, whose sides see it opposite.
/// @param field representation vector of each vertex of the component, from its first one on
LargeArray<double> PhaseDifferences(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const Complex* field);

/// The square of the gradient of the section of unit length with the same directions at each vertex
/// of the mesh, in 1 / unit^2: a third of the Dirichlet energies of the linear interpolations over
/// the triangles at the vertex (sum of half cotangents times 2 - 2 cos omega), over a third of
/// their areas. At least 0.
std::vector<double> EnergyDensity(
  const IntrinsicGeometry& geometry, int degree, const std::vector<Complex>& field);
}

#endif
