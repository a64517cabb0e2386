// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Rounding_h
#define DirectionFields_Rounding_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The largest rounding error of the coordinates of a component, in units of the input. It follows
/// from the precision that all of them have in common: six or seven decimal digits, as in text
/// files, single precision, or double precision.
double RoundingError(
  const std::vector<Vector3>& positions, const TriangleMesh::Component& component);
}

#endif
