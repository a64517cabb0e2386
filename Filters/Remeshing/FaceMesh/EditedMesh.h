// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EditedMesh_h
#define DirectionFields_EditedMesh_h

#include "FaceMesh/FaceMesh.h"
#include "FaceMesh/VertexStars.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Takes the edits of a mesh's faces over into the mesh, without the faces and vertices that are no
/// longer used, and with the edges that its lines have now. Returns the new number of each vertex,
/// None for those that are gone.
std::vector<Index> TakeOver(const VertexStars& stars, FaceMesh& mesh);
}

#endif
