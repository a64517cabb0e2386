// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SizedRows_h
#define DirectionFields_SizedRows_h

#include "FaceMesh/MovableFaces.h"
#include "Progress.h"

#include <functional>
#include <vector>

namespace DirectionFields::Internal
{
/// What a mesh with rows for its sizes is on.
struct RowsDomain
{
  const ClosestPoints& Surface;
  const std::vector<ClosestPoints>& Lines;
  /// The wanted length of edges at places.
  std::function<std::vector<double>(const std::vector<Vector3>&)> LengthsAt;
  std::function<VertexPatches(const FaceMesh&)> PatchesOf;
};

/// Puts rows of quads in where edges are longer than wanted, and takes some out where they are
/// shorter, two at a time. They begin and end at the boundary, or inside of the surface at pairs of
/// vertices of three and five faces. Of all rounds the mesh with most edges as wanted is taken; if
/// that is the given one, nothing changes. Returns whether it did. Throws Stopped.
bool AddSizedRows(FaceMesh& mesh, const RowsDomain& domain, const Progress& progress = {});
}

#endif
