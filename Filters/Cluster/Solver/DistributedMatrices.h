// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedMatrices_h
#define DistributedMatrices_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Processes.h"
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

/// All processes call it, also processes without vertices of the component; throws ProcessesError,
/// and std::runtime_error on all.
/// @param component of the whole surface that lies across processes
/// @param rowOf     room for a row of each vertex of the mesh, whatever is in it
DistributedMatrices AssembleMatrices(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, int component, int degree, double energyBias,
  std::vector<PetscInt>& rowOf);
}

#endif
