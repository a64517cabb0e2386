// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef RemeshToPolyData_h
#define RemeshToPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Quality/QualityReport.h>
#include <DirectionFields/Remesh.h>

class vtkPolyData;

namespace DirectionFields
{
/// Fills an empty output with a mesh, the point data of the surface that it was made of, and its
/// own arrays.
/// @param input   of which the surface was made
/// @param surface the input's triangles, which the mesh refers to
void AddMesh(vtkPolyData* input, const TriangulatedPolyData& surface, const RemeshResult& mesh,
  vtkPolyData* output);

/// Gives a mesh the arrays of its quality.
void AddQuality(const FaceQuality& quality, const QualityReport& judged, vtkPolyData* output);

/// Fills an empty output with the irregular vertices of a mesh.
/// @param degree        the number of edges of a regular vertex
/// @param pointDataType VTK_DOUBLE for points in double precision
void AddIrregularVertices(
  const RemeshResult& mesh, int degree, int pointDataType, vtkPolyData* output);
}

#endif
