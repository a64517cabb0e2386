// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FieldToPolyData_h
#define FieldToPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/DirectionField.h>
#include <DirectionFields/Progress.h>

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace DirectionFields
{
/// Adds the field's point, cell and field data to a copy of the polydata it was computed from,
/// whose points and cells are split where the surface was split for the field. The directions, the
/// magnitude and the curvature are double if that is the type given, else float.
///
/// Throws Stopped; the output is incomplete then.
/// @param type VTK's number of a type
void AddFieldArrays(const TriangulatedPolyData& input, const Result& field, int type,
  vtkPolyData* output, const Progress& progress = {});

/// The same without the figures of how the field was computed, for one that was not; in the type of
/// the points.
void AddGivenField(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output,
  const Progress& progress = {});

/// Removes every array that a field may have left in the point, cell and field data.
void RemoveFieldArrays(vtkPolyData* output);

/// Adds the counts of repairs, and the warnings if there are any.
void AddReport(
  const Repairs& repaired, const std::vector<std::string>& warnings, vtkFieldData* data);

/// Adds the line that describes what a filter has made.
void AddSummary(const std::string& summary, vtkFieldData* data);

/// Removes the figures, the warnings and the summary that one of these filters has written, which
/// are not true of the output that another filter makes of it. Data without a summary are not
/// theirs, and stay as they are.
void RemoveReports(vtkFieldData* data);
/// Shallow copy without these reports.
void CopyWithoutReports(vtkPolyData* input, vtkPolyData* output);
/// Removes the figures of the computation, but for arrays that the output shares with the input.
/// @param input may be null
void RemoveDiagnostics(vtkFieldData* input, vtkFieldData* output);
}

#endif
