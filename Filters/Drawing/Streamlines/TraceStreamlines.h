// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TraceStreamlines_h
#define DirectionFields_TraceStreamlines_h

#include "Interpolation/GivenField.h"
#include "Progress.h"
#include "Streamlines/StreamlinePoints.h"

#include <array>
#include <vector>

namespace DirectionFields::Internal
{
/// Where lines start.
enum class SeedType
{
  /// So that each family of lines covers the surface evenly.
  EvenlySpaced = 0,
  /// At the singularities: the lines that end in them (separatrices).
  Singularities = 1,
  /// At points given.
  Points = 2
};

/// Which way lines from points run, for n = 1.
enum class IntegrationDirection
{
  Both = 0,
  Forward = 1,
  Backward = 2
};

/// Lengths are in the unit of the surface.
struct StreamlineOptions
{
  SeedType Seeds = SeedType::EvenlySpaced;
  /// Distance between lines of a family, not negative; 0: the root of the area / 40. No less than the root
  /// of the area / 1000.
  double Spacing = 0.0;
  /// Evenly spaced lines end where they would come nearer to others than this part of it, 0.1 to 0.9.
  double Ratio = 0.5;
  /// Not negative; 0: 20 times the root of the area.
  double MostLength = 0.0;
  /// Shorter lines are left out, not negative; 0: 0.9 times the spacing for evenly spaced lines, else nothing.
  double LeastLength = 0.0;
  /// Lines from singularities end where they cross each other (MotorcycleGraph.h).
  bool StopAtCrossings = false;
  IntegrationDirection Way = IntegrationDirection::Both;
  /// Most lines, 1 to 10000000.
  Index MostLines = 100000;
  /// Height of the lines above the surface as a part of the spacing, -1 to 1: outwards on surfaces
  /// that enclose a volume, whichever way these are wound, with holes or without; else along the normals.
  double Offset = 0.03;
};

/// A place of the surface where lines start.
struct StreamlineSeed
{
  /// Of the surface; None gives no line.
  Index Triangle = None;
  std::array<double, 3> Weights = {};
};

/// Traces lines along a field. Where the surface cannot be oriented, lines run on over both of its sides.
///
/// Throws std::invalid_argument for options out of their ranges.
/// @param directions as they were given to the field
/// @param seeds      for SeedType::Points
Streamlines TraceStreamlines(const GivenField& field, const PointDirections& directions,
  const std::vector<StreamlineSeed>& seeds, const StreamlineOptions& options,
  const ProgressFunction& progress = {});
}

#endif
