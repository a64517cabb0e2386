// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshExtraction_h
#define DirectionFields_MeshExtraction_h

#include "FaceMesh/Faces.h"
#include "Geometry/SurfaceGeometry.h"
#include "Parametrization/ComponentMap.h"
#include "Progress.h"

#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// The faces that are extracted from the map of one component.
struct ExtractedMesh
{
  struct Vertex
  {
    Vector3 Position;
    /// The number of its feature, from 1 on; 0 elsewhere.
    Index Line = 0;
    /// The same vertex of the surface's mesh, or None for a new one.
    Index Origin = None;
    bool IsBoundary = false;
    /// Features end, meet or turn here.
    bool IsCorner = false;
    /// A singularity of the field.
    bool IsCone = false;
    /// Of the field, in units of 1/n; 0 except at cones.
    int SingularityIndex = 0;
  };

  std::vector<Vertex> Vertices;
  Faces Cells;
  /// An edge of a feature, and the feature's number.
  struct LineEdge
  {
    std::array<Index, 2> Ends;
    Index Line;
  };
  std::vector<LineEdge> LineEdges;
  /// Why there is no map, if there is none: the faces are the component's triangles then.
  std::optional<MapFailure> Failure;
  /// Vertices that could not be removed although they are no grid points; triangles that the map
  /// flips; integers that were rounded; cones of the map.
  Index KeptVertices = 0;
  Index FlippedTriangles = 0;
  Index Integers = 0;
  Index Cones = 0;
};

/// The faces of a component: the cells of its map, or its triangles if it has no map. Throws
/// Stopped.
ExtractedMesh ExtractMesh(
  const SurfaceGeometry& geometry, const ComponentMap& map, const Progress& progress = {});

/// Whether a map has so many integers (MostRounded) that it takes far longer than its faces do.
bool AreCostly(const std::vector<ExtractedMesh>& extracted);
}

#endif
