// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EdgeMiddles_h
#define DirectionFields_EdgeMiddles_h

#include "SolverFiles/ShellEdges.h"

namespace DirectionFields::Internal
{
/// Where curved edges through the points of a mesh have their middles: those of cubic curves whose
/// ends are at right angles to the normals of the faces there (as A. Vlachos et al.: Curved PN
/// Triangles, 2001, but exact on circles). Normals are means of faces that differ by less than 40
/// degrees. Edges of one face, of more than two, and between faces that differ by more are parts of
/// lines, whose circles through each three points in a row give the directions; lines end where
/// they meet or turn by 40 degrees. Where lines end, and where other edges come to lines, an edge
/// is bent as at its other end. A middle that would be farther from the straight one than an eighth
/// of the edge is straight.
std::vector<Vector3> MiddlesOf(const ShellMesh& mesh, const ShellEdges& edges);
}

#endif
