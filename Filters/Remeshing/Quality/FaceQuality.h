// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceQuality_h
#define DirectionFields_FaceQuality_h

#include "Types.h"

#include <array>
#include <vector>

namespace DirectionFields
{
/// The shape of each face of a mesh, by the definitions of the Verdict library (C. Stimpson et al.:
/// The Verdict Geometric Quality Library, SAND2007-1751), which vtkMeshQuality uses, too. None of
/// them has a unit.
struct FaceQuality
{
  /// The least sine of an angle, of triangles relative to 60 degrees: 1 at most, for squares and
  /// even triangles; 0 where an edge has no length, and below 0 for quads that are folded.
  std::vector<double> ScaledJacobian;
  /// The longest edge times the circumference over four times the area, of triangles over the root
  /// of 3 more: 1 at least, for squares and even triangles; 1e30 for a face without area.
  std::vector<double> AspectRatio;
  /// 1 - c^3, c being the less of the two cosines of the angles between the normals at opposite
  /// corners: 0 for a plane quad and for triangles, 2 at most. The measure of vtkMeshQuality is c^3
  /// itself.
  std::vector<double> Warpage;
};

/// @param faces corners of each; the fourth one of a triangle is None
FaceQuality QualityOf(
  const std::vector<Vector3>& points, const std::vector<std::array<Index, 4>>& faces);
}

#endif
