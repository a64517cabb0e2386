// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ComponentMap_h
#define DirectionFields_ComponentMap_h

#include "Charts/FeatureLines.h"
#include "Geometry/SurfaceGeometry.h"
#include "Parametrization/IntegerGridMap.h"
#include "Parametrization/ParametrizationCache.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
/// A surface, its field and its features, from which the components are mapped one by one.
struct ParametrizationInput
{
  const SurfaceGeometry& Geometry;
  const FieldMatching& Matching;
  const std::vector<Complex>& Section;
  /// Features that a map spoils are taken out while the components are mapped, and so are the
  /// vertices that have no frame because of them.
  FeatureLines Features;
  std::vector<char> IsFrameless;
  /// 1 / h of each vertex, h the wanted length of edges there.
  std::vector<double> PerLength;
  /// Of each component; they save work where other lengths are wanted later.
  std::vector<ParametrizationCache>& Caches;
};

/// The map of one component.
struct ComponentMap
{
  const TriangleMesh::Component& Component;
  /// Owned by the component's cache.
  const CutMesh& Mesh;
  IntegerGridMap Map;
};

/// Maps a component. Features that a map spoils, and those in narrow corners, are dropped, and the
/// component is mapped again without them. Throws Stopped.
ComponentMap MapComponent(ParametrizationInput& input, const TriangleMesh::Component& component,
  const Progress& progress = {});
}

#endif
