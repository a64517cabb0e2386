// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PolyDataToSurface_h
#define PolyDataToSurface_h

#include "Conversion/Input/TriangulatedPolyData.h"

#include <DirectionFields/Progress.h>

#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// Triangles are taken as they are. Polygons are cut by their ears; one that cannot be cut so (no
/// area, self-intersecting) becomes a fan, or other triangles if it has many corners. Holes that
/// are joined to the outline by bridges, which are run along twice, stay open. Polygons around the
/// same points are cut alike, so that their triangles are the same ones. Strips are unrolled with
/// alternating winding. Vertices, lines and cells marked as hidden in vtkGhostType give no
/// triangle; cells marked as duplicates give ghosts.
///
/// Throws std::length_error for more points or triangles than Index can number, std::out_of_range
/// for cells with points that are not there, MeshError where coordinates of cells are not finite
/// or beyond what CoordinateCheck allows, and Stopped.
/// @param polyData has passed CheckPolyData
TriangulatedPolyData PolyDataToSurface(vtkPolyData* polyData, const Progress& progress = {});

/// Whether PolyDataToSurface makes this surface, by value. Does not look at polygons: false
/// wherever there is anything but points in single or double precision and triangles.
/// @param polyData has passed CheckPolyData
bool IsSurfaceOf(vtkPolyData* polyData, const TriangulatedPolyData& surface);

/// Whether the points, in single or double precision, are those of this surface, by value.
bool ArePointsOf(vtkPolyData* polyData, const TriangulatedPolyData& surface);

/// For each point whether vtkGhostType marks it as a duplicate of another piece's, or as hidden.
/// Empty where there is no such array.
std::vector<char> GhostPoints(vtkPolyData* polyData);
}

#endif
