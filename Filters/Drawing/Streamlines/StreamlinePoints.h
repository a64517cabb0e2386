// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StreamlinePoints_h
#define DirectionFields_StreamlinePoints_h

#include "Streamlines/TracedStreamline.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// What lines start and end at.
enum class NodeType
{
  Singularity = 0,
  Crossing = 1,
  Boundary = 2
};

struct LineNode
{
  Vector3 Position;
  NodeType Type = NodeType::Singularity;
  /// Of a singularity, in units of 1/n; else 0.
  int SingularityIndex = 0;
  /// The triangle of the surface.
  Index Triangle = None;
};

/// Lines along a field. Points and lines are numbered line by line.
struct Streamlines
{
  std::vector<Vector3> Points;
  /// Unit vectors: of the surface, along the line.
  std::vector<Vector3> Normals, Directions;
  /// Length from the line's begin; |u|.
  std::vector<double> Arc, Magnitude;
  /// The corner of the triangle that is nearest, and which of the directions there is nearest to the line's.
  std::vector<Index> Point;
  std::vector<int> Branch;
  /// The points of line i: Offsets[i] ... Offsets[i + 1] - 1. A closed line ends in its first point.
  std::vector<std::int64_t> Offsets = { 0 };

  /// The number of the seed: of the point given, of the singularity's node, or of the line itself.
  std::vector<Index> Seed;
  std::vector<int> Family;
  std::vector<double> Length;
  std::vector<char> Closed;
  std::vector<std::array<LineEnd, 2>> Ends;
  /// The nodes where the line begins and ends; None where it does not in one.
  std::vector<std::array<Index, 2>> EndNodes;

  /// All singularities, crossings and ends at the boundary, in this order.
  std::vector<LineNode> Nodes;

  /// The distance that was kept between lines, or that the offset goes by.
  double Spacing = 0.0;
  /// There would be more than MostLines.
  bool IsLimited = false;
  /// Stopped by the progress callback; there are no lines.
  bool Aborted = false;
};

/// The points of lines in space, what is known at them, and the nodes, on the threads of the scope.
/// @param lines  each with pieces
/// @param height of the points above the surface, in its unit
Streamlines ToStreamlines(const GivenField& field, const PointDirections& directions,
  const SingularPoints& zeros, const std::vector<TracedStreamline>& lines, double height);
}

#endif
