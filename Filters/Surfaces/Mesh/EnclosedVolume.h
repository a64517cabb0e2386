// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EnclosedVolume_h
#define DirectionFields_EnclosedVolume_h

#include "Mesh/TriangleMesh.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Whether a component is closed and wound inside out: the volume that it encloses is negative, as
/// the sum of signed tetrahedra. Double sheets, which enclose next to nothing, are not.
/// @param component the number of the component
/// @param positions of the vertices, in any unit of length
/// @param unit      the length that the area is measured by
/// @param area      of the component, in unit^2
bool IsWoundInsideOut(const TriangleMesh& mesh, Index component,
  const std::vector<Vector3>& positions, double unit, double area);
}

#endif
