// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedMatrices_h
#define DistributedMatrices_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Solver/PetscObjects.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// Energy and mass matrix of one component of the whole surface, each row on the process that owns
/// the vertex.
struct DistributedMatrices
{
  /// The vertices of the own rows, one after the other.
  std::vector<Index> Vertices;
  /// The first own row.
  PetscInt FirstRow = 0;
  /// As Operators: Hermitian, of the same pattern, in units of Unit.
  OwnedMat Energy;
  OwnedMat Mass;
  /// A length in the unit of the input.
  double Unit = 1.0;
  /// The area of the component, in Unit^2.
  double Area = 0.0;
};

/// The processes that have parts of a component call it, also those without vertices of their own;
/// throws std::runtime_error on all of them, and as DoOnAll does.
/// @param members   of these processes
/// @param processes which they are, in ascending order
/// @param component of the whole surface that lies across processes
/// @param rowOf     room for a row of each vertex of the mesh, whatever is in it
DistributedMatrices AssembleMatrices(const Messages& members, const std::vector<int>& processes,
  const DistributedMesh& mesh, int component, int degree, double energyBias,
  std::vector<PetscInt>& rowOf);
}

#endif
