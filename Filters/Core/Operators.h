// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Operators_h
#define DirectionFields_Operators_h

#include "Connection.h"

namespace DirectionFields
{
/// Energy and mass matrix of one connected component, Hermitian, full storage, in units of the
/// component's mean edge length. Row and column v belong to the vertex FirstVertex + v.
struct Operators
{
  SparseMatrix Energy;
  SparseMatrix Mass;
};

/// Assembles in time linear in the triangles.
/// @param degree     n
/// @param energyBias s
Operators AssembleOperators(const TriangleMesh& mesh, const Metric& metric,
  const Connection& connection, const TriangleMesh::Component& component, int degree,
  double energyBias);
}

#endif
