// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/SurfaceGeometry.h"

#include <utility>

namespace DirectionFields
{
namespace
{
std::vector<double> AtVertices(const TriangleMesh& mesh, const std::vector<double>& sizes)
{
  std::vector<double> atVertices;
  for (Index v = 0; !sizes.empty() && v < mesh.GetNumberOfVertices(); ++v)
  {
    atVertices.push_back(sizes[mesh.Point(v)]);
  }
  return atVertices;
}
}

SurfaceGeometry::SurfaceGeometry(const Surface& surface)
  : SurfaceGeometry(TriangleMesh(surface), surface)
{
}

SurfaceGeometry::SurfaceGeometry(
  TriangleMesh&& mesh, const Surface& surface, const std::vector<double>& sizes)
  : SurfaceGeometry(std::move(mesh), mesh.Positions(surface.Points), AtVertices(mesh, sizes))
{
}

SurfaceGeometry::SurfaceGeometry(
  TriangleMesh&& mesh, std::vector<Vector3>&& positions, const std::vector<double>& sizesAtVertices)
  : IntrinsicGeometry(std::move(mesh), std::move(positions), sizesAtVertices)
  , Frames(this->Mesh, this->Transport, this->Positions)
{
}
}
