// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_KeptFeatures_h
#define DirectionFields_KeptFeatures_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Which edges of a surface are to be edges of a mesh.
struct FeatureSettings
{
  bool AreKept;
  /// As Options::FeatureAngle, degrees.
  double Angle;
  /// As Options::MinimumFeatureLength.
  double MinimumLength;
  /// Chains that end freely are dropped where they are shorter than this, in the input's unit: a
  /// mesh could not show them. So are closed ones.
  double ShortestChain;
};

/// Not 0 for each edge that is to be kept: of the sharp ones as the settings say, and of the hard
/// ones all. Takes time linear in the edges.
/// @param isHard not 0 for edges that are kept whatever their angles and lengths; empty for none
std::vector<char> FindFeatures(const SurfaceGeometry& geometry, const FeatureSettings& settings,
  const std::vector<char>& isHard = {});

/// Takes those chains out that settings.ShortestChain says, but for hard edges.
void DropShortFeatures(const SurfaceGeometry& geometry, const FeatureSettings& settings,
  std::vector<char>& isFeature, const std::vector<char>& isHard = {});

/// The direction of the sharpest feature at each vertex, of length 1; zero where there is none, and
/// on the boundary. Of flat features any.
std::vector<Vector3> FeatureDirections(
  const SurfaceGeometry& geometry, const std::vector<char>& isFeature);
}

#endif
