// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ComponentMap.h"

#include "Parametrization/NarrowCorners.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// Maps of a component, each with fewer features than the one before; one less where each takes
/// long, as with the integers of hundreds of handles.
constexpr int MostAttempts = 3;
constexpr int MostCostlyAttempts = 2;

IntegerGridMap::Settings SettingsFor(const ParametrizationInput& input,
  const TriangleMesh::Component& component, const CutMesh& cutMesh)
{
  IntegerGridMap::Settings settings;
  settings.PerLength.assign(cutMesh.Positions.size(), 0.0);
  std::copy(input.PerLength.begin() + component.FirstVertex,
    input.PerLength.begin() + component.EndVertex, settings.PerLength.begin());
  for (const CutMesh::MapTriangle& t : cutMesh.Triangles)
  {
    // The cones are the first corners of their triangles.
    if (t.Vertex[0] >= component.Vertices())
    {
      settings.PerLength[t.Vertex[0]] = settings.PerLength[t.Vertex[1]];
    }
  }
  return settings;
}

/// Drops features that a map spoils, for a better map without them. The boundary stays. Returns
/// whether there were any.
bool DropFeatures(ParametrizationInput& input, const TriangleMesh::Component& component,
  const std::vector<Index>& edges)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  bool hasDropped = false;
  for (const Index e : edges)
  {
    if (mesh.Twin(mesh.HalfEdge(e)) != None)
    {
      input.Features.IsFeature[e] = 0;
      input.Features.Line[e] = 0;
      hasDropped = true;
    }
  }
  if (hasDropped)
  {
    UpdateFrameless(input.Geometry, input.Matching.Degree, component, input.Features.IsFeature,
      input.IsFrameless);
  }
  return hasDropped;
}
}

ComponentMap MapComponent(
  ParametrizationInput& input, const TriangleMesh::Component& component, const Progress& progress)
{
  DropFeatures(input, component,
    EdgesInNarrowCorners(input.Geometry, component, input.Matching, input.Features,
      input.IsFrameless, input.PerLength));
  const TriangleMesh& mesh = input.Geometry.Mesh;
  ParametrizationCache& cache = input.Caches[&component - mesh.GetComponents().data()];
  for (int attempt = 1;; ++attempt)
  {
    const CutMesh& cutMesh = cache.MeshFor(
      input.Geometry, component, input.Matching, input.Features, input.IsFrameless, input.Section);
    const IntegerGridMap::Settings settings = SettingsFor(input, component, cutMesh);
    ParametrizationEnergy& energy = cache.EnergyFor(settings.PerLength);
    const int most = energy.IsFactored() ? MostAttempts : MostCostlyAttempts;
    IntegerGridMap map(energy, settings, progress);
    cache.Shrink(static_cast<double>(component.Triangles()) /
      static_cast<double>(mesh.GetNumberOfTriangles()));
    const bool isLast = attempt >= most || map.GetFailure();
    if (isLast || !DropFeatures(input, component, map.GetCollapsedFeatures()))
    {
      return { component, cutMesh, std::move(map) };
    }
  }
}
}
