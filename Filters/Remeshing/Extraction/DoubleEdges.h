// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DoubleEdges_h
#define DirectionFields_DoubleEdges_h

#include "Extraction/ExtractionMesh.h"

namespace DirectionFields::Internal
{
/// Where several edges join the same two vertices, as in a fin that touches itself along an edge,
/// puts a vertex on all of them but one: in the extracted mesh faces and edges are identified by
/// their corners.
void SplitDoubleEdges(ExtractionMesh& mesh);
}

#endif
