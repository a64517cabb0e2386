// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Faces_h
#define DirectionFields_Faces_h

#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Triangles and quads. The corners are counter-clockwise; the fourth one of a triangle is None.
struct Faces
{
  using Face = std::array<Index, 4>;
  std::vector<Face> Corners;
  /// Whether a face is a cell of the integer grid.
  std::vector<char> IsRegular;

  static int Size(const Face& face) { return face[3] == None ? 3 : 4; }
};

/// The mean of the corners of a face.
Vector3 MiddleOf(const std::vector<Vector3>& points, const Faces::Face& face);

/// Half the product of the diagonals of a quad; of a triangle its area along its normal.
Vector3 AreaVector(const std::vector<Vector3>& points, const Faces::Face& face);

/// The area of a face; of a quad that of its projection along the product of its diagonals.
double AreaOf(const std::vector<Vector3>& points, const Faces::Face& face);

/// The scaled Jacobian of a face, as the Verdict library and vtkMeshQuality define it: the least
/// sine of the angles at its corners, negative where the face is folded; of a triangle relative to
/// 60 degrees.
double ScaledJacobian(const std::vector<Vector3>& points, const Faces::Face& face);

/// The edges of all faces, each once, with the lower point first, in ascending order.
std::vector<std::array<Index, 2>> EdgesOf(const Faces& faces);

/// The part of all edges, from 0 to 1, whose length is within a quarter of the wanted one: the mean
/// of the wishes at its ends. 1 without edges, and without wishes.
/// @param wanted   length at each point, in the unit of the points; empty for none
double EdgesAsWanted(
  const std::vector<Vector3>& points, const Faces& faces, const std::vector<double>& wanted);

/// V - E + F of a mesh with this number of points.
int EulerCharacteristic(Index points, const Faces& faces);
}

#endif
