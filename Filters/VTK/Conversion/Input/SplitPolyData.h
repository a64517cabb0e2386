// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SplitPolyData_h
#define SplitPolyData_h

#include "Conversion/Input/TriangulatedPolyData.h"

#include <DirectionFields/DirectionField.h>

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// Splits a copy of the polydata where its surface was split for the field because it is no
/// manifold: appends the points that were split off, each with the point data of its original, and
/// gives the polygons and strips the points of their triangles. A cell whose triangles were torn
/// apart keeps the points of the first of them. Adds the array OriginalPointIds. Nothing changes
/// where nothing was split.
/// @return the points that no polygon or strip uses; empty where nothing was split
std::vector<vtkIdType> SplitPolyData(
  const TriangulatedPolyData& input, const Result& field, vtkPolyData* output);
}

#endif
