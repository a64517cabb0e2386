// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GlyphsToPolyData_h
#define GlyphsToPolyData_h

#include <DirectionFields/Glyphs.h>

class vtkPolyData;

namespace DirectionFields
{
/// Adds points, cells and arrays of the glyphs to an empty output. The points are double if the
/// given data type is, else float.
/// @param field that they show, whose tensors, where it has any, give values along the glyphs
void AddGlyphs(const Glyphs& glyphs, int pointDataType, vtkPolyData* field, vtkPolyData* output);
}

#endif
