// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ParametrizationCache.h"

#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Factors of up to this number of values are cached, 24 megabytes. Factors of large meshes would
/// take much of the memory while faces are made, which takes most of the time there.
constexpr std::size_t MostValues = 3000000;
/// They are cached only for components with at least this part of all triangles: while one of many
/// components is factored memory is short, and the factors of all others would stay in it.
constexpr double LeastShare = 0.5;
}

ParametrizationCache::Features::Features(const TriangleMesh::Component& component,
  const FeatureLines& features, const std::vector<char>& isFrameless)
{
  for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
  {
    if (features.IsFeature[e] != 0 || features.Line[e] != 0)
    {
      this->Edges.push_back(
        { e, features.IsFeature[e], features.Line[e], features.Axis[e], features.Base[e] });
    }
  }
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    if (isFrameless[v] != 0)
    {
      this->Frameless.push_back(v);
    }
    if (!features.IsEnd.empty() && features.IsEnd[v] != 0)
    {
      this->Ends.push_back(v);
    }
  }
}

const CutMesh& ParametrizationCache::MeshFor(const SurfaceGeometry& geometry,
  const TriangleMesh::Component& component, const FieldMatching& matching,
  const FeatureLines& features, const std::vector<char>& isFrameless,
  const std::vector<Complex>& section)
{
  Features wanted(component, features, isFrameless);
  if (this->Mesh == nullptr || !(this->Made == wanted))
  {
    this->Energy.reset();
    this->Mesh.reset();
    this->Made = std::move(wanted);
    const CutGraph graph(geometry, component, matching, features, isFrameless);
    this->Mesh = std::make_unique<const CutMesh>(
      geometry, component, matching, features, isFrameless, graph, section);
  }
  return *this->Mesh;
}

ParametrizationEnergy& ParametrizationCache::EnergyFor(const std::vector<double>& perLength)
{
  if (this->Energy == nullptr || !this->Energy->IsFor(perLength))
  {
    this->Energy.reset();
    this->Energy = std::make_unique<ParametrizationEnergy>(*this->Mesh, perLength);
  }
  return *this->Energy;
}

void ParametrizationCache::Shrink(double share)
{
  if (this->Energy != nullptr && !this->Energy->IsFactored())
  {
    this->Energy.reset();
  }
  else if (this->Energy != nullptr)
  {
    this->Energy->Shrink(share < LeastShare ? 0 : MostValues);
  }
}
}
