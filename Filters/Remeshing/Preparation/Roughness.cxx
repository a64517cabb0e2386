// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/Roughness.h"

#include "Features/FeatureChains.h"
#include "Geometry/DihedralAngles.h"
#include "Options.h"

#include <cmath>
#include <vector>

namespace DirectionFields::Internal
{
bool IsRough(const SurfaceGeometry& geometry)
{
  // Models of few triangles have up to a fifth. A body of fewer edges is its facets.
  constexpr double leastPart = 0.25;
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
