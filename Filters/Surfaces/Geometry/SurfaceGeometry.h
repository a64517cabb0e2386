// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceGeometry_h
#define DirectionFields_SurfaceGeometry_h

#include "Geometry/IntrinsicGeometry.h"
#include "Geometry/TangentFrames.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields
{
/// All that is computed of a surface before anything of a field is: its mesh, the lengths and the
/// parallel transport on it, and how its tangent planes lie in space.
struct SurfaceGeometry : IntrinsicGeometry
{
  /// Takes time linear in the triangles. Throws MeshError for a surface that cannot be processed.
  explicit SurfaceGeometry(const Surface& surface);
  /// @param mesh    of the surface, or of the surface with points merged
  /// @param surface whose points the mesh has
  /// @param sizes   at each point, above 0, in the metric of which all of it is but for the
  ///                Positions, as Metric says; empty for the surface's own metric
  SurfaceGeometry(
    TriangleMesh&& mesh, const Surface& surface, const std::vector<double>& sizes = {});

  TangentFrames Frames;

private:
  /// Positions and sizes are found before the mesh is moved away.
  SurfaceGeometry(TriangleMesh&& mesh, std::vector<Vector3>&& positions,
    const std::vector<double>& sizesAtVertices);
};
}

#endif
