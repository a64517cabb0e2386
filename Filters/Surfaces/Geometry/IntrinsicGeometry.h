// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntrinsicGeometry_h
#define DirectionFields_IntrinsicGeometry_h

#include "Geometry/Connection.h"
#include "Geometry/Metric.h"
#include "Mesh/TriangleMesh.h"

namespace DirectionFields
{
/// A triangulation of a surface with all that can be measured without leaving the surface: lengths,
/// angles and the parallel transport of tangent vectors. Operators, double covers and singularities
/// need no more than this. A SurfaceGeometry is one that lies in space, an IntrinsicTriangulation
/// one whose edges run straight over the surface of another.
struct IntrinsicGeometry
{
  TriangleMesh Mesh;
  Metric Lengths;
  Connection Transport;

protected:
  /// @param positions of the vertices, which the lengths are taken from
  /// @param sizes     as those of Metric
  IntrinsicGeometry(TriangleMesh&& mesh, const std::vector<Vector3>& positions,
    const std::vector<double>& sizes = {})
    : Mesh(std::move(mesh))
    , Lengths(this->Mesh, positions, sizes)
    , Transport(this->Mesh, this->Lengths, positions)
  {
  }
};
}

#endif
