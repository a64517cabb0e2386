// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TestGeometry_h
#define DirectionFields_TestGeometry_h

#include "Connection.h"
#include "Metric.h"
#include "TangentFrames.h"
#include "TestMeshes.h"
#include "TriangleMesh.h"

#include <cmath>

/// What is computed of a surface before anything of a field is.
namespace TestGeometry
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
