// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Geometry_h
#define DirectionFields_Geometry_h

#include "Geometry/Connection.h"
#include "Geometry/Metric.h"
#include "Geometry/TangentFrames.h"
#include "Mesh/TriangleMesh.h"
#include "Meshes/Surfaces.h"

#include <cmath>

/// What is computed of a surface before anything of a field is.
namespace SurfaceParts
{
using namespace DirectionFields;

struct Geometry
{
  explicit Geometry(const Surface& surface)
    : Mesh(surface)
    , Points(this->Mesh.Positions(surface.Points))
    , Lengths(this->Mesh, this->Points)
    , Transport(this->Mesh, this->Lengths, this->Points)
    , Frames(this->Mesh, this->Transport, this->Points)
  {
  }
  TriangleMesh Mesh;
  std::vector<Vector3> Points;
  Metric Lengths;
  Connection Transport;
  TangentFrames Frames;
};

/// An angle in [-pi, pi].
inline double Wrapped(double angle)
{
  return std::remainder(angle, 2.0 * Pi);
}
}

#endif
