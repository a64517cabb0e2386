// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_AffordableFeatures_h
#define DirectionFields_AffordableFeatures_h

#include "Features/KeptFeatures.h"
#include "Geometry/SurfaceGeometry.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Edges of a lower dihedral angle than this, in degrees, are taken for flat: rounding bends them.
/// With the others the edges that split a plane would be features, at which no vertex could move.
constexpr double LeastFeatureAngle = 0.5;

/// The angle from which on edges are features, if those that are wanted meet at more points than
/// the faces can follow: each is a point of the grid that its neighbours depend on, so that memory
/// grows with the square of their number, and time with its cube.
struct AffordableFeatures
{
  /// It takes a time linear in the triangles, and almost none at the usual angle and above. Throws
  /// MeshError.
  /// @param faces how many are wanted
  AffordableFeatures(const Surface& input, const FeatureSettings& wanted, int degree, double faces);

  /// What the user is told; none where the angle is the wanted one.
  std::vector<std::string> Sentences() const;

  FeatureSettings Settings;
  double Wanted;
  /// The points where features of the wanted angle meet or end.
  Index Meeting = 0;
};

/// Features that may be no edges of a shape but how coarsely a bent surface is cut into triangles:
/// it bends at its edges by all angles. Of the length of all edges that are sharper than the wanted
/// angle more than 2 % are in each of the six bands, an eighth wide, from that angle to twice that.
/// Edges of a shape have a few angles. Features that are too short to be kept count as well, since
/// chance decides which ones are long.
struct AccidentalFeatures
{
  /// @param angle the wanted one, in degrees
  AccidentalFeatures(const SurfaceGeometry& geometry, double angle);

  /// What the user is told where they are left out.
  std::string Sentence() const;

  bool IsAny = false;
  double Wanted;
};
}

#endif
