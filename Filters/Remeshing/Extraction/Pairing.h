// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Pairing_h
#define DirectionFields_Pairing_h

#include "Extraction/ExtractionMesh.h"
#include "FaceMesh/Faces.h"

namespace DirectionFields::Internal
{
/// Joins the triangles of a cell mesh of degree 4 in pairs: first the two halves of every unit square of the
/// lattice, then others where that makes good quads, best first. No feature is taken out, and no vertex is left with
/// two faces in the interior. For degree 6 the triangles are the faces.
Faces PairTriangles(const ExtractionMesh& mesh);

/// Quads of less quality than this are not made of triangles that are no cell of the lattice.
constexpr double LeastQuality = 0.15;
}

#endif
