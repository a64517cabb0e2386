// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Assembly_h
#define DirectionFields_Assembly_h

#include "Geometry/IntrinsicGeometry.h"
#include "Matrices/Operators.h"

namespace DirectionFields
{
/// Assembles in time linear in the triangles. Edges that join the same vertices add up, as do
/// edges that join a vertex to itself.
/// @param degree     n
/// @param energyBias s
Operators AssembleOperators(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, double energyBias);
}

#endif
