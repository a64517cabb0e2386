// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FieldToPolyData_h
#define FieldToPolyData_h

#include "DirectionField.h"
#include "PolyDataToSurface.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace DirectionFields
{
/// Adds the field's point, cell and field data to a copy of the polydata it was computed from.
/// The directions and the magnitude are double if the points are, else float. False where the
/// progress function stopped it; the output is incomplete then.
bool AddFieldArrays(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output,
  const ProgressFunction& progress = {});

/// Adds the counts of what was mended, and the warnings if there are any.
void AddReport(
  const Repairs& repaired, const std::vector<std::string>& warnings, vtkFieldData* data);

/// Makes a vertex at the centroid of every triangle whose index is not 0, but for ghosts. points: of the input.
void MakeSingularities(const TriangulatedPolyData& input, const Result& field, int pointDataType,
  vtkPolyData* singularities);
}

#endif
