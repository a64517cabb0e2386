// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TriangleParity_h
#define DirectionFields_TriangleParity_h

#include "FaceMesh/FaceMesh.h"

namespace DirectionFields::Internal
{
/// Makes the number of triangles even in every region between lines, so that they can be joined in pairs: edges of lines
/// are cut in two, which makes a triangle more of each face there, a quad becoming a triangle and a quad. The regions
/// whose number is odd are led to each other, or to the boundary, over few lines and where the faces are good. Returns false where
/// regions are odd that only meet others in edges of more than two faces; the mesh is as it was then.
bool EvenOutTriangles(FaceMesh& mesh);
}

#endif
