// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ComparisonToPolyData_h
#define ComparisonToPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Comparison/FieldDerivatives.h>
#include <DirectionFields/Comparison/FieldDifference.h>

#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// Adds the point and field data of a difference.
void AddDifference(const FieldDifference& difference, vtkPolyData* output);

/// Adds the cell data of the derivatives of a field. A polygon has the mean over its triangles.
/// @param number of the field, which is the end of the arrays' names
void AddDerivatives(const TriangulatedPolyData& surface, const FieldDerivatives& derivatives,
  int number, vtkPolyData* output);

/// Adds the field data of matched singularities, and vertices and lines of them to an empty output.
void AddMatches(const TriangulatedPolyData& surface,
  const std::vector<ComparedSingularity>& singularities, vtkPolyData* output, vtkPolyData* matches);
}

#endif
