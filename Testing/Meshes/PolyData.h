// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PolyData_h
#define DirectionFields_PolyData_h

#include "Surface.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

/// The surfaces of the tests as VTK takes them, and back.
namespace Meshes
{
/// @param precision data type of the points: VTK_FLOAT or VTK_DOUBLE
vtkSmartPointer<vtkPolyData> ToPolyData(
  const DirectionFields::Surface& surface, int precision = VTK_DOUBLE);

/// The points and the triangles of polydata whose polygons are all triangles.
DirectionFields::Surface ToSurface(vtkPolyData* mesh);
}

#endif
