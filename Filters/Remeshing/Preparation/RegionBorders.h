// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RegionBorders_h
#define DirectionFields_RegionBorders_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Not 0 for each edge between triangles of different regions; empty where no regions are given.
/// Edges of the boundary, and of more than two triangles, are none: these are kept anyway.
/// @param regions of the triangles that the mesh was made of; empty for one region
std::vector<char> EdgesBetween(const TriangleMesh& mesh, const std::vector<Index>& regions);

/// Makes the edges of curves hard, too.
/// @param curves   the points at the ends of each edge, the lower one first, ascending
/// @param original of each point of the mesh's surface the one that it is a copy of, or itself
/// @param isHard   not 0 for each edge that is hard already; empty for none
void AddCurves(const TriangleMesh& mesh, const std::vector<std::array<Index, 2>>& curves,
  const std::vector<Index>& original, std::vector<char>& isHard);

/// Takes the chains of borders out that run in stairs: where regions were drawn on a surface, their
/// borders turn to and fro at its triangles, which no row of faces can follow. A chain does where a
/// twentieth of its edges are shorter than a length and join opposite turns of more than 20
/// degrees. Where borders are closer than that length to each other on the whole, as those of noise
/// are, all are taken out.
/// @param isHard   not 0 for each edge of a border
/// @param shortest in the input's unit
/// @return the part of the borders' length that was taken out
double DropStairs(const SurfaceGeometry& geometry, std::vector<char>& isHard, double shortest);
}

#endif
