// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GivenPolyData_h
#define GivenPolyData_h

#include <DirectionFields/Exchange/FieldExport.h>
#include <DirectionFields/Interpolation/GivenField.h>
#include <DirectionFields/Surface.h>

#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// Throws std::invalid_argument, with the filter that helps, where a polygon has more than three
/// corners or there are strips.
void RequireTriangles(vtkPolyData* polyData);
/// Whether all polygons are triangles, there are no strips, and no cell is hidden.
bool HasOnlyTriangles(vtkPolyData* polyData);

/// The files that hold the field of polydata (ExportField).
/// @param polyData has passed CheckPolyData and RequireTriangles
/// @param surface  of it
std::vector<ExportedFile> FilesOfPolyData(
  vtkPolyData* polyData, const Surface& surface, const ExportOptions& options);
}

#endif
