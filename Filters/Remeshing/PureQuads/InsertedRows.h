// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_InsertedRows_h
#define DirectionFields_InsertedRows_h

#include "FaceMesh/FaceMesh.h"

namespace DirectionFields::Internal
{
/// Makes quads of triangles in pairs by a row of faces more between them: the quads on a way from
/// one to the other are halved along it, into three where it turns, and each triangle gets the end
/// of the row as its fourth corner. No face becomes flat by it and no edge of a line is changed,
/// whatever room there is. The vertices in the middles of edges are on these.
/// Returns the number of triangles that are left: those to which no way leads over edges of no
/// line.
Index InsertRows(FaceMesh& mesh);
}

#endif
