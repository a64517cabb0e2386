// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef InterpolatedData_h
#define InterpolatedData_h

#include "Conversion/Input/TriangulatedPolyData.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkCellData;
class vtkPointData;
class vtkPolyData;

namespace DirectionFields
{
/// Three points of an input and their weights.
using WeightedPoints = std::pair<Triangle, std::array<double, 3>>;

/// Gives another mesh of the same surface the input's point data: real numbers and colors, which
/// are bytes of three or four components, interpolated; other integers, which may be ids, are those
/// of the point with the largest weight, the first one of several. Directions, which are not to be
/// interpolated, and marks of the input's own points are left out.
/// @param count of the mesh's points
void InterpolatePointData(vtkPolyData* input, std::size_t count,
  const std::function<WeightedPoints(std::size_t)>& at, vtkPointData* output);

/// Gives the cells of another mesh of the same surface the data of the input's cells, with the same
/// exceptions.
/// @param triangles the triangle of the surface that each cell lies in
void CopyCellData(vtkPolyData* input, const TriangulatedPolyData& surface,
  const std::vector<Index>& triangles, vtkCellData* output);

/// Whether an array of cells of this name is one of those exceptions.
bool IsLeftOutAtCells(const std::string& name);
}

#endif
