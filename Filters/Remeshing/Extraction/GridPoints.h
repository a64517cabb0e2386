// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GridPoints_h
#define DirectionFields_GridPoints_h

#include "Extraction/ExtractionMesh.h"

namespace DirectionFields::Internal
{
/// Puts a vertex at every grid point in the image of a map: on the features, and inside and on the
/// edges of positive triangles. Existing vertices at grid points are marked to stay. Then the mesh
/// is made Delaunay in the plane of the grid: four grid points around an empty square become the
/// corners of two halves of it, three around an empty triangle those of a unit triangle.
void InsertGridPoints(ExtractionMesh& mesh);
}

#endif
