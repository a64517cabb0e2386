// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshExtraction_h
#define DirectionFields_MeshExtraction_h

#include "Charts/FeatureLines.h"
#include "FaceMesh/Faces.h"
#include "Geometry/SurfaceGeometry.h"
#include "Parametrization/ParametrizationCache.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The faces that one component is cut into.
struct ExtractedMesh
{
  struct Vertex
  {
    Vector3 Position;
    /// The number of the feature that it lies on, from 1 on; 0 elsewhere.
    Index Line = 0;
    /// The vertex of the surface's mesh that it is, or None.
    Index Origin = None;
    bool IsBoundary = false;
    /// Features end, meet or turn here.
    bool IsCorner = false;
    /// A singularity of the field.
    bool IsCone = false;
    /// Of the field, in units of 1/n; 0 but at cones.
    int SingularityIndex = 0;
  };

  std::vector<Vertex> Vertices;
  Faces Cells;
  /// An edge that is part of a feature, and the number of that.
  struct LineEdge
  {
    std::array<Index, 2> Ends;
    Index Line;
  };
  std::vector<LineEdge> LineEdges;
  /// Why there is no map, or null: the faces are the component's triangles then.
  const char* Failure = nullptr;
  /// Vertices that could not be removed although they are no lattice points; triangles that the map turns
  /// over; integers that were rounded; cones of the map.
  Index KeptVertices = 0;
  Index FlippedTriangles = 0;
  Index Integers = 0;
  Index Cones = 0;
};

/// What of a field and a mesh the cells of all components are made from.
struct ExtractionInput
{
  const SurfaceGeometry& Geometry;
  const FieldMatching& Charts;
  /// Features of which no line can become are taken out while cells are made, and so are the corners that
  /// they made.
  FeatureLines& Features;
  std::vector<char>& IsFrameless;
  const std::vector<Complex>& Section;
  /// 1 / h of each vertex, h the wanted length of edges there.
  const std::vector<double>& PerLength;
  /// Of each component; they spare work for cells of another size.
  std::vector<ParametrizationCache>& Maps;
};

/// Throws Stopped.
ExtractedMesh ExtractMesh(const ExtractionInput& input, const TriangleMesh::Component& component,
  const Progress& progress = {});
}

#endif
