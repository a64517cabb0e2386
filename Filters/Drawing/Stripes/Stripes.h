// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Stripes_h
#define DirectionFields_Stripes_h

#include "Progress.h"
#include "Stripes/StripePoints.h"
#include "Stripes/WantedPhases.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace DirectionFields::Internal
{
struct StripeOptions
{
  StripeDirection Direction = StripeDirection::Along;
  /// Distance from one stripe to the next in the surface's unit of length, not negative; 0: the root of its area / 40.
  double Spacing = 0.0;
  /// How far lines are from the phase 0, as a part of the spacing, -1 to 1. Where the field is a line field, whose
  /// sense is open, only multiples of 1/2 mean something, and the nearest is taken.
  double LineOffset = 0.0;
  /// Whether the surface is to be cut into bands, and whether these are to have phases at their corners.
  bool Bands = true;
  bool BandPhases = false;
};

/// A triangle of the surface around which the stripes do not close up.
struct StripeSingularity
{
  Vector3 Position;
  /// The triangle of the surface.
  Index Triangle;
  /// How many lines begin there: the sum of the steps of the phase counter-clockwise around it, in cycles. Stripes of
  /// one sheet only have a sign here.
  int StripeIndex;
  /// The index of the field there, in units of 1/n.
  int FieldIndex;
};

struct StripePattern
{
  /// Lines in the middles of stripes. Points and lines are numbered line by line.
  std::vector<StripePoint> LinePoints;
  std::vector<Vector3> LinePositions;
  std::vector<Vector3> LineNormals;
  /// Length from the line's begin.
  std::vector<double> Arc;
  /// The points of line i: LineOffsets[i] ... LineOffsets[i + 1] - 1. A closed line ends in its first point.
  std::vector<std::int64_t> LineOffsets = { 0 };
  std::vector<char> Closed;
  std::vector<double> Length;
  /// The singularities that lines begin and end in; None at the boundary and for closed lines.
  std::vector<std::array<Index, 2>> EndSingularities;

  /// The surface cut into bands (StripeBands).
  std::vector<StripePoint> BandPoints;
  std::vector<Vector3> BandPositions;
  std::vector<Vector3> BandNormals;
  std::vector<std::int64_t> BandCorners;
  std::vector<std::int64_t> BandOffsets = { 0 };
  std::vector<char> Stripe;
  std::vector<Index> BandTriangle;
  std::vector<float> BandPhases;

  /// Where stripes branch or end (StripeIndex is not 0), and where they turn around an odd singularity of a line field.
  std::vector<StripeSingularity> Singularities;
  /// The number of those that have an index.
  Index BranchPoints = 0;
  /// Of those more than one line begins or ends at, where the mesh is too coarse for the spacing.
  Index CrowdedBranchPoints = 0;
  double Misfit = 0.0;
  /// The spacing where none is given for each point; 0 with a function.
  double Spacing = 0.0;
  /// The offset that was taken.
  double LineOffset = 0.0;
};

/// Evenly spaced stripes that follow a field of degree 1 or 2. Takes time linear in the triangles and in the length of
/// the lines.
///
/// Throws std::invalid_argument for other degrees, for options out of their ranges, and for a spacing so small that
/// there would be more than a hundred million crossings of lines and edges. Throws Stopped.
/// @param spacing at each point of the surface, in place of the option; where it is not positive and finite there are
///                no stripes; or empty
StripePattern MakeStripes(const GivenField& field, const StripeOptions& options,
  const std::function<double(Index point)>& spacing = {}, const Progress& progress = {});
}

#endif
