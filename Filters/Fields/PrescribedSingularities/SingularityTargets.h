// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularityTargets_h
#define DirectionFields_SingularityTargets_h

#include "PrescribedSingularities/EditOptions.h"
#include "TrivialConnection/TrivialConnection.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// A singularity that is asked for.
struct PrescribedSingularity
{
  /// In a triangle of the mesh, on the front, with weights of the mesh's corners.
  MeshPlace Place;
  /// In units of 1/n.
  int Index;
};

/// The target of a component with singularities in it. Where a triangle is asked for a larger index
/// than it can have, the rest goes to the nearest triangles with one ring of others between them.
/// Throws std::invalid_argument, with a sentence for the user, where the indices of a closed region
/// do not add up to its base's, or the mesh is too coarse.
/// @param positions of the vertices of the mesh
/// @param notes     gets a sentence for singularities that were added or moved
RotationTarget MakeTarget(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const TrivialConnection& rotation,
  const std::vector<Vector3>& positions, const std::vector<PrescribedSingularity>& singularities,
  const EditOptions& options, std::vector<std::string>& notes);
}

#endif
