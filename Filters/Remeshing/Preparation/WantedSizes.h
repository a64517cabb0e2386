// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WantedSizes_h
#define DirectionFields_WantedSizes_h

#include "Geometry/SurfaceGeometry.h"
#include "Preparation/PreparedSurface.h"
#include "Surface.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The wanted lengths of edges over a surface: a length times a size, which may differ from point
/// to point.
struct WantedSizes
{
  /// Whether the size is 1 everywhere.
  bool IsEven = true;
  /// Whether rows of quads begin and end for them: for those that the user gives. For those of an
  /// error other lengths would do as well, and the rows make a front's faces worse for it.
  bool HasRows = false;
  /// The size at each point of the input, and at each vertex of the prepared mesh.
  std::vector<double> AtPoints;
  std::vector<double> AtVertices;
  /// The wanted length where the size is 1, and the one of the mesh that is extracted from the map:
  /// twice as long where its faces will be split.
  double EdgeLength = 0.0;
  double MapLength = 0.0;
  /// The length that was asked for, or that the wanted number of faces gives for the area.
  /// EdgeLength is longer on thin surfaces.
  double LengthForArea = 0.0;

  /// Whether they differ from point to point.
  bool AreUneven() const;
  /// 1 / h of each vertex, h the length of the map's edges there.
  std::vector<double> PerLength() const;
  /// Half of the length of the mesh's edges at each vertex.
  std::vector<double> HalfLengths() const;
  /// Takes smaller sizes where edges may not be as long.
  /// @param longest length of edges at each point of the surface, above 0; empty for any length
  /// @param area    of the surface with the sizes that there are, as RelativeArea
  /// @param isFixed whether edges keep their length elsewhere; otherwise they get longer there, by
  ///                1.4 at most, and edges at thin parts as long as a quarter more faces allow
  void Shrink(
    const std::vector<double>& longest, const Surface& surface, double area, bool isFixed);
  /// Makes the edges longer on surfaces narrower than a face, see LeastEdgeLength.
  void LengthenFor(const SurfaceGeometry& geometry, Index faces);
};

/// The largest size of edges relative to others; the smallest is its inverse.
constexpr double LargestSize = 8.0;

/// The sizes that are asked for at each point, in this range. Where no positive number is
/// given, and without any, the size is 1.
std::vector<double> ClampedSizes(const std::vector<double>& wanted, std::size_t points);

/// The area in units of the square of the size there. Coordinates that are not finite are refused
/// later.
/// @param sizes one at each point, above 0
double RelativeArea(const Surface& surface, const std::vector<double>& sizes);

/// How long the edges of the surface are on which field and map are computed. It is not decimated
/// where the triangles are few already and no needles, and edges between one and
/// two wanted lengths are split: wanted lengths within a factor of two share such a surface and
/// everything computed on it. Nothing is split where the surface as a whole is thinner than four
/// faces, as needles and strips.
/// @param area as RelativeArea
WorkingLengths LengthsFor(
  const Surface& surface, const std::vector<double>& sizes, double area, double edgeLength);

/// Shortest edge length that yields about `faces` faces on surfaces narrower than a face, whose
/// faces all touch the boundary: its length counts there, not the area.
/// @param sizes one at each vertex, above 0
double LeastEdgeLength(
  const SurfaceGeometry& geometry, const std::vector<double>& sizes, Index faces);
}

#endif
