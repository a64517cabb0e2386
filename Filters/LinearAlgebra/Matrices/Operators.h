// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Operators_h
#define DirectionFields_Operators_h

#include "Types.h"

namespace DirectionFields
{
/// Energy and mass matrix of one connected component, in units of the component's mean edge length.
/// Row and column v belong to the vertex FirstVertex + v.
///
/// The solvers expect:
/// - Both are Hermitian, compressed and stored in full. The energy is positive semi-definite, the
///   mass matrix positive definite.
/// - They have the same pattern: each has an entry at all places where one of them is not zero, its
///   rows in ascending order, the diagonal among them.
/// - The phase of the entry M_ij of the mass matrix is that of the transport of sections from
///   vertex j to vertex i, up to a part of the curvature of the triangles at the edge. Multigrid
///   reads the transport off it, since the energy's entries change sign where cotangent weights are
///   negative. A mass matrix that is lumped into its diagonal does not tell the transport.
struct Operators
{
  Operators() = default;
  Operators(const Operators&) = default;
  Operators& operator=(const Operators&) = default;
  /// Eigen would copy the matrices.
  Operators(Operators&& other) noexcept { this->Swap(other); }
  Operators& operator=(Operators&& other) noexcept
  {
    this->Swap(other);
    return *this;
  }
  void Swap(Operators& other) noexcept
  {
    this->Energy.swap(other.Energy);
    this->Mass.swap(other.Mass);
  }

  SparseMatrix Energy;
  SparseMatrix Mass;
};
}

#endif
