// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Streamlines_h
#define DirectionFields_Streamlines_h

#include "Interpolation/GivenField.h"
#include "Progress.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields
{
/// Where streamlines start.
enum class SeedType
{
  /// So that each family of lines covers the surface evenly (Jobard and Lefer 1997).
  EvenlySpaced = 0,
  /// At the singularities: the lines that end in them, called separatrices.
  Singularities = 1,
  /// At given points.
  Points = 2
};

/// How lines from points run along a field of degree 1.
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
  /// Distance between neighbouring lines of a family, 0 or more; 0 stands for the root of the area
  /// / 40. It is raised to the root of the area / 1000, and lowered to the sum of that root and the
  /// diagonal of the surface's box.
  double Spacing = 0.0;
  /// Evenly spaced lines end where their distance from others falls below this part of the spacing,
  /// 0.1 to 0.9.
  double Ratio = 0.5;
  /// Greatest length of a line, 0 or more; 0 stands for 20 times the root of the component's area.
  double MaximumLength = 0.0;
  /// Shorter lines are left out, 0 to MaximumLength. 0 leaves out evenly spaced lines shorter than
  /// 0.9 times the spacing or MaximumLength (on small components, than a quarter of the root of the
  /// area), and no others.
  double MinimumLength = 0.0;
  /// Lines from singularities end where they cross each other: together they are the motorcycle
  /// graph of the field (Eppstein, Goodrich, Kim and Tamstorf 2008).
  bool StopAtCrossings = false;
  /// Of lines from points, for degree 1; lines of other fields always run in both directions.
  IntegrationDirection Direction = IntegrationDirection::Both;
  /// Greatest number of lines, 1 to 10000000. With StopAtCrossings all lines are traced, as each
  /// may stop others, and those of the first singularities are given.
  Index MaximumNumber = 100000;
  /// Height of the lines above the surface as a part of the spacing, -1 to 1: outwards on surfaces
  /// that enclose a volume, whichever way their triangles are wound, with holes or without;
  /// elsewhere along the normals.
  double Offset = 0.03;
};

/// A place on the surface where lines start.
struct StreamlineSeed
{
  /// A triangle of the surface; None gives no line.
  Index Triangle = None;
  /// Barycentric weights of the triangle's corners; negative ones count as 0.
  std::array<double, 3> Weights = {};
};

/// Why a line ends. The first numbers are those of vtkStreamTracer.
enum class StreamlineEnd
{
  /// It has not ended: no more of it was asked for.
  None = 0,
  /// The boundary of the surface, or an edge of more than two triangles.
  Boundary = 1,
  /// StreamlineOptions::MaximumLength.
  Length = 4,
  /// The integration takes steps without progress.
  Stuck = 5,
  Singularity = 6,
  /// The line is closed: it has come back to its start.
  Loop = 7,
  /// Another line of the family, or an earlier part of this one, is too close.
  TooClose = 8,
  /// Another line crosses this one, with StreamlineOptions::StopAtCrossings.
  Crossing = 9
};

/// A place where lines begin or end.
enum class StreamlineNodeType
{
  Singularity = 0,
  Crossing = 1,
  Boundary = 2
};

struct StreamlineNode
{
  Vector3 Position;
  StreamlineNodeType Type = StreamlineNodeType::Singularity;
  /// Index of a singularity in units of 1/n; 0 for the other types.
  int SingularityIndex = 0;
  /// The triangle of the surface that the node lies in.
  Index Triangle = None;
};

/// Lines along a field. Arrays over points and arrays over lines are ordered line by line.
struct Streamlines
{
  /// Over the points: their positions, StreamlineOptions::Offset above the surface.
  std::vector<Vector3> Points;
  /// Over the points: unit vectors, the surface's normal and the tangent of the line.
  std::vector<Vector3> Normals, Directions;
  /// Over the points: the length from the begin of the line, and |u|, the magnitude of the field.
  std::vector<double> Arc, Magnitude;
  /// Over the points: the nearest corner of the triangle as a point of the surface, and the number
  /// k of the direction there that is nearest to the line's.
  std::vector<Index> Point;
  std::vector<int> Branch;
  /// Over the points: the triangle of the surface that each is in, and the weights of its corners,
  /// with which values at the points of the surface are carried to the lines.
  std::vector<Index> Triangle;
  std::vector<std::array<double, 3>> Weights;
  /// Line i has the points Offsets[i] ... Offsets[i + 1] - 1. A closed line repeats its first point
  /// at its end.
  std::vector<std::int64_t> Offsets = { 0 };

  /// Over the lines: the number of the given seed, or of the singularity's node; for evenly spaced
  /// lines the number that the line had before short ones were left out.
  std::vector<Index> Seed;
  /// Over the lines: lines that cross are of different families, 0 ... n/2 - 1 for even n, 0 ... n
  /// - 1 for odd n.
  std::vector<int> Family;
  std::vector<double> Length;
  /// Over the lines: 1 for closed ones, else 0.
  std::vector<char> Closed;
  /// Over the lines: why they end, at their begin and at their end.
  std::vector<std::array<StreamlineEnd, 2>> Ends;
  /// Over the lines: the nodes where they begin and end; None where there is no node.
  std::vector<std::array<Index, 2>> EndNodes;

  /// All singularities, then all crossings where lines end, then all ends at the boundary.
  std::vector<StreamlineNode> Nodes;

  /// The spacing that was used, in the unit of the surface.
  double Spacing = 0.0;
  /// StreamlineOptions::MaximumNumber was reached: there may be more lines.
  bool IsLimited = false;
  /// The progress function stopped the computation; there are no lines.
  bool Aborted = false;
};

/// Traces streamlines of a direction field on a surface, on the threads of the calling thread's
/// Threads::Scope. Within each triangle a line is a solution of z' = d(z), where d is the
/// direction, of the n that the field has at z, nearest to the last one; the field between the
/// vertices is the section that its energy integrates (Knöppel et al. 2013, section 6.1). On
/// surfaces that cannot be oriented, lines run on over both sides. The result does not depend on
/// the number of threads.
///
/// Sources: B. Jobard, W. Lefer: Creating Evenly-Spaced Streamlines of Arbitrary Density, 1997.
/// D. Eppstein, M. Goodrich, E. Kim, R. Tamstorf: Motorcycle Graphs: Canonical Quad Mesh
/// Partitioning, 2008.
///
/// @param field      made of these directions
/// @param directions the n directions at each point of the surface
/// @param seeds      for SeedType::Points; ignored for the other types
/// @param progress   returns false to stop: Streamlines::Aborted is set then
/// @throw std::invalid_argument for options out of their ranges, and for evenly spaced lines that
///        would have many million points: on a surface thinner than the spacing, too
Streamlines TraceStreamlines(const GivenField& field, const PointDirections& directions,
  const std::vector<StreamlineSeed>& seeds = {}, const StreamlineOptions& options = {},
  const ProgressFunction& progress = {});
}

#endif
