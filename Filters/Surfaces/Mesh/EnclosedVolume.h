// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EnclosedVolume_h
#define DirectionFields_EnclosedVolume_h

#include "Mesh/TriangleMesh.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Whether a closed surface that encloses this volume, as the sum of signed tetrahedra, is wound
/// inside out. Double sheets, which enclose next to nothing, are not.
/// @param volume in the cube of a length
/// @param area   in the square of it
bool IsWoundInsideOut(double volume, double area);

/// Whether a component is closed and wound inside out.
/// @param component the number of the component
/// @param positions of the vertices, in any unit of length
/// @param unit      the length that the area is measured by
/// @param area      of the component, in unit^2
bool IsWoundInsideOut(const TriangleMesh& mesh, Index component,
  const std::vector<Vector3>& positions, double unit, double area);
}

#endif
