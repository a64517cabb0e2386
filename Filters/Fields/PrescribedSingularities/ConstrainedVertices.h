// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConstrainedVertices_h
#define DirectionFields_ConstrainedVertices_h

#include "Geometry/SurfaceGeometry.h"
#include "Types.h"

#include <cmath>
#include <vector>

namespace DirectionFields::Internal
{
/// The directions that the vertices of a mesh are to keep, unit complex numbers in their tangent
/// frames; 0 where a vertex has none: the vector is zero, not finite, or upright on the surface.
/// @param constraints one a point of the surface; empty for none
inline std::vector<Complex> ConstrainedVertices(
  const SurfaceGeometry& geometry, const std::vector<Vector3>& constraints)
{
  constexpr double LeastTangential = 1e-6;
  if (constraints.empty())
  {
    return {};
  }
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Complex> directions(mesh.GetNumberOfVertices(), 0.0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Vector3& direction = constraints[mesh.Point(v)];
    if (direction.allFinite() && !direction.isZero(0.0))
    {
      const Complex tangential = geometry.Frames.Tangential(v, direction.stableNormalized());
      const double length = std::abs(tangential);
      directions[v] = length > LeastTangential ? tangential / length : 0.0;
    }
  }
  return directions;
}
}

#endif
