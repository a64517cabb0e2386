// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SingularPoints_h
#define SingularPoints_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Computation/SurfaceFigures.h>
#include <DirectionFields/DirectionField.h>

class vtkPolyData;

namespace DirectionFields
{
/// Makes a vertex at the centroid of every triangle whose index is not 0, except for ghosts.
/// @param figures       of the whole surface, which give the balls their size
/// @param pointDataType of the input's points; the singularities are double or float as well
void MakeSingularPoints(const TriangulatedPolyData& input, const Result& field,
  const SurfaceFigures& figures, int pointDataType, vtkPolyData* singularities);
}

#endif
