// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Rounding_h
#define DirectionFields_Rounding_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The largest error that rounding has left in the coordinates of a component, in units of the input, by
/// what all of them have in common: numbers of six or seven decimal digits, as files of text have them,
/// numbers of single precision, or of double precision.
double RoundingError(
  const std::vector<Vector3>& positions, const TriangleMesh::Component& component);
}

#endif
