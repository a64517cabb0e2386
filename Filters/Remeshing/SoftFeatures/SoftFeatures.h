// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SoftFeatures_h
#define DirectionFields_SoftFeatures_h

#include "Features/KeptFeatures.h"
#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// What a rim has to be: a chain of edges that are bent less than features are, and stand out all
/// the same, as those of a fillet of few triangles.
struct SoftFeatureSettings
{
  /// For features of these settings. There are none where their angle is below 15 degrees, as
  /// rounding, or above 90, which leaves out what is far from soft.
  SoftFeatureSettings(const FeatureSettings& features, double face, double room);

  bool AreKept() const
  {
    return this->Face > 0.0 && this->Room > 0.0 && this->MostBend > this->LeastBend;
  }

  /// The angles between the normals of an edge's triangles, radians.
  double LeastBend;
  double MostBend;
  /// The size of a usual face, in the input's unit.
  double Face;
  /// What is free of other lines to both sides of a rim, in that unit.
  double Room;
};

/// Which edges of a surface belong to rims.
struct SoftFeatures
{
  /// Not 0 for each edge of a rim; empty where there is none. Features are not among them.
  std::vector<char> IsRim;
  /// Whether there are rims with other rooms.
  bool DependsOnRoom = false;
};

/// An edge of a rim is bent by at least LeastBend, and by several times as much as the edges beside
/// it, those of its two triangles. A rim leads from feature to feature or is longer than some
/// faces. A feature that fades, beyond which a rim ends freely, is not continued: a line along it
/// would end where nothing is. A rim has room: there is no feature or sharper rim beside it closer
/// than Room. Takes a time about linear in the edges.
/// @param isFeature not 0 for each edge that is a feature
SoftFeatures FindSoftFeatures(const SurfaceGeometry& geometry, const std::vector<char>& isFeature,
  const SoftFeatureSettings& settings);

/// Not 0 for each edge that is a feature, and those of them that are soft.
struct AllFeatures
{
  std::vector<char> All;
  SoftFeatures Soft;
  /// Whether they are told from noise (HasNoise).
  bool AreInNoise = false;
};

/// As FindFeatures, or FeaturesInNoise where the surface has noise, with soft features if they are
/// wanted.
/// @param face, room as SoftFeatureSettings; no room for no soft features
AllFeatures FindAllFeatures(const SurfaceGeometry& geometry, const FeatureSettings& settings,
  const std::vector<char>& isHard, double face, double room);
}

#endif
