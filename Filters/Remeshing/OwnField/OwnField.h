// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_OwnField_h
#define DirectionFields_OwnField_h

#include "Geometry/SurfaceGeometry.h"
#include "Progress.h"
#include "Surface.h"

#include <memory>
#include <vector>

namespace DirectionFields::Internal
{
/// How the shape of a surface draws a field of degree 4.
struct ShapeAlignment
{
  /// The strength of the alignment to the principal curvatures, from 0 for none to 1, as
  /// Options::AlignmentStrength.
  double Strength = 0.0;
  /// As Options::SingularityCost, for a strength above 0: without it each wave of the surface has
  /// its own singularities.
  double SingularityCost = 0.0;

  bool operator==(const ShapeAlignment& other) const
  {
    return this->Strength == other.Strength && this->SingularityCost == other.SingularityCost;
  }
};

/// How the mesher makes a field of its own.
struct OwnFieldSettings
{
  /// 4 or 6
  int Degree = 4;
  /// Whether the field runs along the features.
  bool FollowsFeatures = true;
  ShapeAlignment Alignment;
  /// The usual length of an edge of the mesh, above 0, in the surface's unit; corners that are
  /// smaller are left to the map.
  double Face = 0.0;
  /// The wanted size at each point of the surface, above 0; empty for the same everywhere. The
  /// field is the smoothest one in the metric where lengths count in units of the size, and has the
  /// singularities that the sizes need.
  std::vector<double> Sizes;
};

/// Computes a section of unit length over the vertices of a surface, kept along its boundary and
/// its features, drawn to the principal curvatures where the surface is bent differently in two
/// directions. Throws Stopped.
/// @param surface   the surface that the geometry is of
/// @param isFeature not 0 for each edge that is a feature
/// @param known     a direction of the field at each vertex, zero where it is to be computed; empty
///                  to compute it everywhere. It holds on the boundary and on features, too.
std::vector<Complex> OwnField(const std::shared_ptr<const Surface>& surface,
  const SurfaceGeometry& geometry, const std::vector<char>& isFeature,
  const OwnFieldSettings& settings, const std::vector<Vector3>& known, const Progress& progress);
}

#endif
