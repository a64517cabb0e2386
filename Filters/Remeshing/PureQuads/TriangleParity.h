// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TriangleParity_h
#define DirectionFields_TriangleParity_h

#include "FaceMesh/FaceMesh.h"

namespace DirectionFields::Internal
{
/// Makes the number of triangles even in every region between lines, so that they can be joined in
/// pairs: edges of lines are split in two, which adds a triangle to each face there, a quad
/// becoming a triangle and a quad. Odd regions are connected with each other, or with the boundary,
/// over few lines and where the faces are good; if some meet others only in edges of more than two
/// faces, all these edges are split. Edges with Line 0, those of components that are kept as they
/// are, are not split.
/// @param mayCutBoundary whether edges of one face only may be split; a surface whose boundary has
///                       an odd number of edges keeps a triangle otherwise
void EvenOutTriangles(FaceMesh& mesh, bool mayCutBoundary = true);
}

#endif
