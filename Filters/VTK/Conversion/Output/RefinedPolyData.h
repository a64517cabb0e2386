// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef RefinedPolyData_h
#define RefinedPolyData_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/PrescribedSingularities/SurfaceRefinement.h>

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace DirectionFields
{
/// A surface with a field after a refinement: all cells of the input that are triangles, polygons
/// or strips as triangles. New points have the means of the point data at the ends of their edges,
/// and the directions of the field there; between two constrained points they are constrained, too.
/// Triangles have the data of their cells.
vtkSmartPointer<vtkPolyData> RefinedPolyData(vtkPolyData* input,
  const TriangulatedPolyData& surface, const GivenField& field,
  const SurfaceRefinement& refinement);
}

#endif
