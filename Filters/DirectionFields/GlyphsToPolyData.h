// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GlyphsToPolyData_h
#define GlyphsToPolyData_h

#include "Glyphs/Glyphs.h"

class vtkPolyData;

namespace DirectionFields
{
/// The directions in the point data of a vtkPolyData, which must outlive them. Degree is the number
/// of the consecutive arrays Direction0, Direction1, ...; 0 if there is none. Magnitude is 1 where
/// there is no array RepresentationMagnitude. Throws std::invalid_argument where one of these has
/// another number of components, 3 and 1.
/// @param polyData has passed CheckPolyData
PointDirections FindDirections(vtkPolyData* polyData);

/// Adds points, cells and arrays of the glyphs to an empty output. The points are double if the given
/// data type is, else float.
void AddGlyphs(const Glyphs& glyphs, int pointDataType, vtkPolyData* output);
}

#endif
