// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DelaunayFlips_h
#define DirectionFields_DelaunayFlips_h

#include "Extraction/ExtractionMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Flips edges until the interior edges without feature between triangles that lie the right way round are
/// Delaunay in the lattice's plane. No flip joins vertices that are joined already.
/// @param edges half-edges to look at first; is used up
void MakeDelaunay(ExtractionMesh& mesh, std::vector<Index>& edges);
}

#endif
