// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/Roughness.h"

#include "Features/FeatureChains.h"
#include "Geometry/DihedralAngles.h"
#include "Options.h"

#include <cmath>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
/// Whether more edges than a part of them are sharp but no features.
bool AreSharp(const SurfaceGeometry& geometry, double leastPart)
{
  // A body of fewer edges is its facets.
  constexpr Index fewest = 200;
  constexpr double sharp = DefaultFeatureAngle * Pi / 180.0;
  const std::vector<double> dihedral = DihedralAngles(geometry);
  const FeatureChains chains(geometry, dihedral, { sharp, DefaultMinimumFeatureLength });
  Index noise = 0;
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    noise += std::abs(dihedral[e]) > sharp && !chains.IsFeature(e) ? 1 : 0;
  }
  return noise >= fewest &&
    static_cast<double>(noise) > leastPart * static_cast<double>(geometry.Mesh.GetNumberOfEdges());
}
}

bool IsRough(const SurfaceGeometry& geometry)
{
  // Models of few triangles have up to a fifth.
  constexpr double leastPart = 0.25;
  return AreSharp(geometry, leastPart);
}

bool HasNoise(const SurfaceGeometry& geometry)
{
  constexpr double leastPart = 0.1;
  return AreSharp(geometry, leastPart);
}
}
