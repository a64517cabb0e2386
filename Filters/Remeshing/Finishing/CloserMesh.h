// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CloserMesh_h
#define DirectionFields_CloserMesh_h

#include "FaceMesh/Faces.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Faces below this scaled Jacobian are of no use to a solver.
constexpr double LeastUsable = 0.1;
/// A mesh is about as close to the surface as another one if it is farther by this factor at most.
constexpr double AboutAsClose = 1.15;

/// What a mesh of a surface is judged by, beside others of it.
struct MeshStanding
{
  /// The larger one of the distances of mesh and surface from each other.
  double Farthest = 0.0;
  /// The least scaled Jacobian of a face; 0 at most where faces are turned over.
  double LeastQuality = 1.0;
  /// By how much the Euler characteristics of mesh and surface differ.
  int MissedHoles = 0;
  /// Distances below this one are the same, such as those of planes, which are rounding errors.
  double LeastDistance = 0.0;
  /// Regions that have faces, and given points that are vertices.
  Index KeptParts = 0;
};

/// The least scaled Jacobian of a face; 1 without faces.
double LeastQuality(const std::vector<Vector3>& points, const std::vector<Faces::Face>& faces);

/// Whether a mesh is much closer to the surface than another one of it, or has a much better worst
/// face and is about as close. It has neither a worse face nor more holes or handles that the
/// surface has not, and no less of the parts that are to be kept.
bool IsCloser(const MeshStanding& mesh, const MeshStanding& other);
}

#endif
