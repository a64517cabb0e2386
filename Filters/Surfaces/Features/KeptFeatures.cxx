// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/KeptFeatures.h"

#include "Features/EdgeChains.h"
#include "Features/FeatureChains.h"
#include "Geometry/DihedralAngles.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Dropped chains let others grow together, which are looked at again.
constexpr int MostRounds = 4;

/// Returns whether any was dropped.
bool DropShorter(const SurfaceGeometry& geometry, double shortest, std::vector<char>& isFeature,
  const std::vector<char>& isHard)
{
  bool hasDropped = false;
  for (const EdgeChain& chain : ChainsOf(geometry.Mesh, isFeature))
  {
    if (!(chain.IsClosed || chain.EndsFreely) || chain.Length(geometry) >= shortest)
    {
      continue;
    }
    for (const Index e : chain.Edges)
    {
      if (isHard.empty() || isHard[e] == 0)
      {
        isFeature[e] = 0;
        hasDropped = true;
      }
    }
  }
  return hasDropped;
}
}

std::vector<char> FindFeatures(
  const SurfaceGeometry& geometry, const FeatureSettings& settings, const std::vector<char>& isHard)
{
  std::vector<char> isFeature(geometry.Mesh.GetNumberOfEdges(), 0);
  if (settings.AreKept)
  {
    const std::vector<double> dihedral = DihedralAngles(geometry);
    const FeatureChains chains(
      geometry, dihedral, { settings.Angle * Pi / 180.0, settings.MinimumLength });
    for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
    {
      isFeature[e] = chains.IsFeature(e) ? 1 : 0;
    }
  }
  for (std::size_t e = 0; e < isHard.size(); ++e)
  {
    isFeature[e] = isFeature[e] != 0 || isHard[e] != 0 ? 1 : 0;
  }
  if (settings.AreKept)
  {
    DropShortFeatures(geometry, settings, isFeature, isHard);
  }
  return isFeature;
}

void DropShortFeatures(const SurfaceGeometry& geometry, const FeatureSettings& settings,
  std::vector<char>& isFeature, const std::vector<char>& isHard)
{
  for (int k = 0;
       k < MostRounds && DropShorter(geometry, settings.ShortestChain, isFeature, isHard); ++k)
  {
  }
}

std::vector<Vector3> FeatureDirections(
  const SurfaceGeometry& geometry, const std::vector<char>& isFeature)
{
  // Flat features count for less than all sharp ones.
  constexpr double least = 1e-3;
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<double> dihedral = DihedralAngles(geometry);
  std::vector<Vector3> direction(mesh.GetNumberOfVertices(), Vector3::Zero());
  std::vector<double> sharpest(mesh.GetNumberOfVertices(), 0.0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (isFeature[e] == 0)
    {
      continue;
    }
    const Index h = mesh.HalfEdge(e);
    const Vector3 along =
      (geometry.Positions[mesh.Head(h)] - geometry.Positions[mesh.Tail(h)]).normalized();
    for (const Index v : { mesh.Tail(h), mesh.Head(h) })
    {
      const double angle = std::max(std::abs(dihedral[e]), least);
      if (angle > sharpest[v] && !mesh.IsBoundary(v) && along.allFinite())
      {
        sharpest[v] = angle;
        direction[v] = along;
      }
    }
  }
  return direction;
}
}
