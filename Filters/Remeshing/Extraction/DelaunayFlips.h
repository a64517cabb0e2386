// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DelaunayFlips_h
#define DirectionFields_DelaunayFlips_h

#include "Extraction/ExtractionMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Flips edges until all interior edges that are no features and lie between two positive triangles
/// are Delaunay in the plane of the grid. No flip joins two vertices that are already joined.
/// @param edges half-edges to start from; is used up
void MakeDelaunay(ExtractionMesh& mesh, std::vector<Index>& edges);
}

#endif
