// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GridPoints_h
#define DirectionFields_GridPoints_h

#include "Extraction/ExtractionMesh.h"

namespace DirectionFields::Internal
{
/// Puts a vertex at every lattice point that the map of a mesh meets: on the features, and inside of the
/// triangles that lie the right way round and on their edges. Vertices that are at one already are kept.
/// Then the mesh is made Delaunay in the lattice's plane: what is bounded by four lattice points becomes two
/// halves of a unit square (of three, a unit triangle).
void InsertGridPoints(ExtractionMesh& mesh);
}

#endif
