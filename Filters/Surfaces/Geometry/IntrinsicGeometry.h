// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntrinsicGeometry_h
#define DirectionFields_IntrinsicGeometry_h

#include "Geometry/Connection.h"
#include "Geometry/Metric.h"
#include "Mesh/TriangleMesh.h"

#include <utility>
#include <vector>

namespace DirectionFields
{
/// A triangulation of a surface with all that can be measured without leaving the surface: lengths,
/// angles and the parallel transport of tangent vectors. Operators, double covers and singularities
/// need no more than this. A SurfaceGeometry is one that lies in space, an IntrinsicTriangulation
/// one whose edges run straight over the surface of another.
struct IntrinsicGeometry
{
  TriangleMesh Mesh;
  /// The position of each vertex, in the surface's own unit: their order in space decides what
  /// lengths and angles leave open.
  std::vector<Vector3> Positions;
  Metric Lengths;
  Connection Transport;

protected:
  /// @param positions of the vertices, which the lengths are taken from
  /// @param sizes     as those of Metric
  IntrinsicGeometry(
    TriangleMesh&& mesh, std::vector<Vector3>&& positions, const std::vector<double>& sizes = {})
    : Mesh(std::move(mesh))
    , Positions(std::move(positions))
    , Lengths(this->Mesh, this->Positions, sizes)
    , Transport(this->Mesh, this->Lengths, this->Positions)
  {
  }
};
}

#endif
