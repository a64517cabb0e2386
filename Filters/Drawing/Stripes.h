// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Stripes_h
#define DirectionFields_Stripes_h

#include "Interpolation/GivenField.h"
#include "Progress.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace DirectionFields
{
/// How stripes run: along the directions of the field, or at right angles to them.
enum class StripeDirection
{
  Along = 0,
  Across = 1
};

struct StripeOptions
{
  StripeDirection Direction = StripeDirection::Along;
  /// Distance between neighbouring stripes in the surface's unit of length, 0 or more; 0 stands for
  /// the root of its area / 40.
  double Spacing = 0.0;
  /// Distance of the lines from the phase 0 as a part of the spacing, -1 to 1. A field of degree 2
  /// has no sense, which leaves multiples of 1/2 only: the nearest one is used.
  double LineOffset = 0.0;
  /// Whether to cut the surface into bands, and whether to compute the phases at the corners of
  /// these.
  bool Bands = true;
  bool BandPhases = false;
};

/// A place on a triangle of the surface, or on an edge or a point of it: the mean of three points
/// of the surface, with weights that are not negative and sum up to 1. Points of weight 0 may be
/// named more than once.
struct StripePoint
{
  std::array<Index, 3> Points;
  std::array<double, 3> Weights;
};

/// A triangle of the surface around which the stripes do not close up.
struct StripeSingularity
{
  /// The middle of the triangle.
  Vector3 Position;
  Index Triangle;
  /// The number of lines that begin in the triangle: the sum of the steps of the phase
  /// counter-clockwise around it, in cycles. Its sign says more only where the field gives the
  /// phases a sense, as every field of degree 1 does.
  int StripeIndex;
  /// The index of the field in the triangle, in units of 1/n.
  int FieldIndex;
};

struct StripePattern
{
  /// Over the points of the lines, which are the middles of stripes, line by line: places on the
  /// surface, positions in its unit, unit normals, and the length from the begin of the line.
  std::vector<StripePoint> LinePoints;
  std::vector<Vector3> LinePositions;
  std::vector<Vector3> LineNormals;
  std::vector<double> Arc;
  /// Line i has the points LineOffsets[i] ... LineOffsets[i + 1] - 1. A closed line repeats its
  /// first point at its end.
  std::vector<std::int64_t> LineOffsets = { 0 };
  /// Over the lines: 1 for closed ones, else 0; the length; and the singularities that the line
  /// begins and ends in, None at the boundary and for closed lines.
  std::vector<char> Closed;
  std::vector<double> Length;
  std::vector<std::array<Index, 2>> EndSingularities;

  /// The surface cut along the borders of the stripes into convex polygons, each within a triangle
  /// of the surface. Polygons share their points: a closed surface gives closed bands.
  std::vector<StripePoint> BandPoints;
  std::vector<Vector3> BandPositions;
  std::vector<Vector3> BandNormals;
  /// Polygon i has the corners BandCorners[BandOffsets[i]] ... BandCorners[BandOffsets[i + 1] - 1],
  /// counter-clockwise, as numbers of band points.
  std::vector<std::int64_t> BandCorners;
  std::vector<std::int64_t> BandOffsets = { 0 };
  /// Over the polygons: 1 within a quarter of the spacing from the middle of a stripe, 0 between
  /// stripes; and the triangle of the surface.
  std::vector<char> Stripe;
  std::vector<Index> BandTriangle;
  /// Over the corners: the phase in cycles, 0 in the middle of a stripe, linear on each polygon.
  /// From one triangle to the next it may jump by whole cycles and change its sign. Empty without
  /// StripeOptions::BandPhases.
  std::vector<float> BandPhases;

  /// Where stripes branch or end (StripeIndex is not 0), and where they turn around an odd
  /// singularity of a line field.
  std::vector<StripeSingularity> Singularities;
  /// The number of singularities with a StripeIndex other than 0, ghosts not counted.
  Index BranchPoints = 0;
  /// The number of these with more than one line, where the mesh is too coarse for the spacing.
  Index CrowdedBranchPoints = 0;
  /// The root of the mean square by which steps of the phase along the edges differ from the wanted
  /// steps, over that of the wanted steps; 0 for stripes with the wanted directions and spacing
  /// everywhere.
  double Misfit = 0.0;
  /// The spacing that was used; 0 where a function gives it.
  double Spacing = 0.0;
  /// The offset that was used.
  double LineOffset = 0.0;
  /// The progress function stopped the computation; there is no pattern.
  bool Aborted = false;
};

/// Draws evenly spaced stripes that follow a field of degree 1 or 2, on the threads of the calling
/// thread's Threads::Scope, in time linear in the triangles and in the length of the lines. The
/// result does not depend on the number of threads.
///
/// Source: F. Knöppel, K. Crane, U. Pinkall, P. Schröder: Stripe Patterns on Surfaces. ACM
/// Transactions on Graphics 34(4), 2015. Sections of modulus 1 stand in the place of the paper's
/// eigenvector.
///
/// @param spacing  the distance between stripes at each point of the surface, in its unit, instead
///                 of StripeOptions::Spacing; there are no stripes where it is not positive and
///                 finite. May be empty
/// @param progress returns false to stop: StripePattern::Aborted is set then
/// @throw std::invalid_argument for fields of other degrees, for options out of their ranges, and
///        for a spacing so small that lines and edges would cross more than a hundred million times
StripePattern MakeStripes(const GivenField& field, const StripeOptions& options = {},
  const std::function<double(Index point)>& spacing = {}, const ProgressFunction& progress = {});
}

#endif
