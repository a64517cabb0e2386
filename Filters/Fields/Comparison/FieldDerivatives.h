// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldDerivatives_h
#define DirectionFields_FieldDerivatives_h

#include "Interpolation/GivenField.h"

#include <vector>

namespace DirectionFields
{
/// Divergence and curl of the unit vectors of a field on each triangle of the surface, in
/// 1 / length: the flow out of the triangle, and the circulation around it counter-clockwise as the
/// mesh is wound, over its area. Along an edge the field is linear between its values at the ends,
/// measured in the cones of the vertices.
///
/// For degree 2 the vectors are those of one of the two opposite fields that a line field is
/// without singularities; which of them is open, and so is the common sign: moduli are given. Not a
/// number where a corner has no direction, and in triangles where the index of a line field is odd;
/// zero for triangles that the mesh does not have.
struct FieldDerivatives
{
  /// Throws std::invalid_argument for other degrees than 1 and 2.
  explicit FieldDerivatives(const GivenField& field);

  std::vector<double> Divergence;
  std::vector<double> Curl;
};
}

#endif
