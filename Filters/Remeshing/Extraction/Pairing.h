// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Pairing_h
#define DirectionFields_Pairing_h

#include "Extraction/ExtractionMesh.h"
#include "FaceMesh/Faces.h"

namespace DirectionFields::Internal
{
/// Joins the triangles of an extraction mesh of degree 4 in pairs: first the two halves of every
/// unit square of the grid, then other pairs that make good quads, best first. Feature edges stay,
/// and no interior vertex keeps fewer than three faces. For degree 6 the triangles are the faces.
Faces PairTriangles(const ExtractionMesh& mesh);

/// Triangles that are not halves of a unit square are joined only to quads of at least this
/// quality.
constexpr double LeastQuality = 0.15;
}

#endif
