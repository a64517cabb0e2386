// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef LinesToPolyData_h
#define LinesToPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Streamlines.h>

class vtkPointSet;
class vtkPolyData;

namespace DirectionFields
{
/// The places of a surface that are nearest to points, on the threads of the scope; of points that
/// are not finite, and where the surface has no triangle, no place.
std::vector<StreamlineSeed> NearestPlaces(const Surface& surface, vtkPointSet* points);

/// Adds points, cells and arrays of lines to an empty output. The points are double if the given
/// data type is, else float.
/// @param diagnostics whether with the arrays for few: which point, direction and magnitude of the
///                    field is nearest to each point of a line, the families of lines, and where
///                    and why they begin and end
void AddLines(const Streamlines& lines, int pointDataType, bool diagnostics, vtkPolyData* output);

/// Adds the value along the line to the points of lines, interpolated, where the field has tensors.
void AddTensorValues(const Streamlines& lines, const TriangulatedPolyData& surface,
  vtkPolyData* field, vtkPolyData* output);

/// The same for the nodes at which lines start and end.
void AddNodes(const Streamlines& lines, int degree, const TriangulatedPolyData& surface,
  int pointDataType, vtkPolyData* output);
}

#endif
