// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_QuadSplit_h
#define DirectionFields_QuadSplit_h

#include "FaceMesh/FaceMesh.h"

namespace DirectionFields::Internal
{
/// Splits every face of k corners into k quads: with a vertex in the middle of each edge and one in
/// the middle of the face. Edges between two vertices of one feature stay on it.
void SplitIntoQuads(FaceMesh& mesh);
}

#endif
