// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef TriangulatedPolyData_h
#define TriangulatedPolyData_h

#include <DirectionFields/Surface.h>

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace DirectionFields
{
/// The polygons and strips of a vtkPolyData as triangles.
struct TriangulatedPolyData
{
  /// All points of the vtkPolyData, so that point ids stay the user's.
  Surface Mesh;
  /// The cell of a triangle, in the numbering of the vtkPolyData: vertices, lines, polygons,
  /// strips.
  vtkIdType Cell(std::size_t triangle) const
  {
    return this->CellOfTriangle.empty() ? this->FirstCell + static_cast<vtkIdType>(triangle)
                                        : this->CellOfTriangle[triangle];
  }

  /// Empty where the cells from FirstCell on are the triangles.
  std::vector<vtkIdType> CellOfTriangle;
  vtkIdType FirstCell = 0;
};
}

#endif
