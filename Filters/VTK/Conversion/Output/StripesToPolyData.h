// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef StripesToPolyData_h
#define StripesToPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Stripes.h>

class vtkPolyData;

namespace DirectionFields
{
/// Adds points, cells and arrays of a pattern's lines to an empty output. Points are double if the
/// given data type is, else float.
void AddStripeLines(const StripePattern& pattern, int pointDataType, vtkPolyData* output);

/// The same for the bands, with the input's data, and with texture coordinates where the pattern
/// has phases of them.
void AddStripeBands(vtkPolyData* input, const TriangulatedPolyData& surface,
  const StripePattern& pattern, vtkPolyData* output);

/// The same for the places where stripes branch or turn around a singularity of the field.
void AddStripeSingularities(const TriangulatedPolyData& surface, const StripePattern& pattern,
  int pointDataType, vtkPolyData* output);
}

#endif
