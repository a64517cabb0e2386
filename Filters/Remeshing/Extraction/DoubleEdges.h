// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DoubleEdges_h
#define DirectionFields_DoubleEdges_h

#include "Extraction/ExtractionMesh.h"

namespace DirectionFields::Internal
{
/// Where several edges join the same two vertices, as those of a fin that touches itself along an edge do, puts a
/// vertex on all of them but one: faces are told by their corners in the mesh to come, and so are its edges.
void SplitDoubleEdges(ExtractionMesh& mesh);
}

#endif
