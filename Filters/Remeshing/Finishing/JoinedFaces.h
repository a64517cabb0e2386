// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_JoinedFaces_h
#define DirectionFields_JoinedFaces_h

#include "Extraction/MeshExtraction.h"
#include "FaceMesh/FaceMesh.h"
#include "Preparation/Seams.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Puts the faces of all components into one mesh, in which the sides of seams share their
/// vertices.
/// @param isTurn of each vertex of the surface's mesh, see FindTurns. Other corners of the map are
///               not corners of the mesh.
/// @param open   gets the number of seams that stay open
FaceMesh JoinFaces(const std::vector<ExtractedMesh>& components, const Seams& seams,
  const std::vector<char>& isTurn, Index& open);
}

#endif
