// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/SurfaceGeometry.h"

#include <utility>

namespace DirectionFields
{
SurfaceGeometry::SurfaceGeometry(const Surface& surface)
  : SurfaceGeometry(TriangleMesh(surface), surface)
{
}

SurfaceGeometry::SurfaceGeometry(TriangleMesh&& mesh, const Surface& surface)
  : SurfaceGeometry(std::move(mesh), mesh.Positions(surface.Points))
{
}

SurfaceGeometry::SurfaceGeometry(TriangleMesh&& mesh, std::vector<Vector3>&& positions)
  : IntrinsicGeometry(std::move(mesh), positions)
  , Positions(std::move(positions))
  , Frames(this->Mesh, this->Transport, this->Positions)
{
}
}
