// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshChains_h
#define DirectionFields_MeshChains_h

#include "Chains/MeshChain.h"
#include "Charts/FeatureLines.h"
#include "FaceMesh/FaceMesh.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Whether each line, from 1 on, is a part of the boundary of a surface's mesh: sheets that were
/// taken apart meet there, if it is none of the new mesh.
std::vector<char> LinesOfBoundary(const TriangleMesh& mesh, const FeatureLines& features);

/// The chains of the edges of a mesh that are its boundary, features, or borders of regions: each
/// of these edges is in one chain. They are ordered by kind, curve, regions and place. Takes
/// n log n time.
/// @param isSeam  not 0 for the lines of the mesh, from 1 on, that are no features where they are
///                within it
/// @param curves  the number of the curve that each line edge of the mesh is on, or None; empty for
///                no curves
/// @param regions of the faces; empty for none
/// @param names   of the regions, by their numbers; empty for the numbers themselves
std::vector<MeshChain> FindChains(const FaceMesh& mesh, const std::vector<char>& isSeam,
  const std::vector<Index>& curves, const std::vector<Index>& regions,
  const std::vector<std::string>& names);
}

#endif
