// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Rounding_h
#define DirectionFields_Rounding_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The precision that some coordinates have in common.
struct Precision
{
  double Largest = 0.0;
  bool IsSingle = true;
  bool HasSixDigits = true;
  bool HasSevenDigits = true;

  Precision& operator+=(const Precision& other);
  /// The largest rounding error of coordinates of this precision.
  double RoundingError() const;
};

/// That of the vertices of a component.
Precision PrecisionOf(
  const std::vector<Vector3>& positions, const TriangleMesh::Component& component);

/// The largest rounding error of the coordinates of a component, in units of the input. It follows
/// from the precision that all of them have in common: six or seven decimal digits, as in text
/// files, single precision, or double precision.
double RoundingError(
  const std::vector<Vector3>& positions, const TriangleMesh::Component& component);
}

#endif
