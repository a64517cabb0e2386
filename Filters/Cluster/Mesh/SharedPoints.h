// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SharedPoints_h
#define SharedPoints_h

#include "Mesh/Messages.h"
#include "Processes.h"
#include "SurfacePiece.h"

#include "vtkType.h"

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

namespace DirectionFields::Parallel
{
/// Which points of a piece other pieces have, too, found out without gathering more than the
/// borders.
struct SharedPoints
{
  /// Numbers of points that are the same on all processes: each point has an owner, the first
  /// process with it, whose own points are numbered from FirstNumber[process] on in their order.
  std::vector<vtkIdType> FirstNumber;
  /// The number of each own point.
  std::vector<vtkIdType> Number;
  /// The place of each own point: that which its owner has.
  std::vector<double> Coordinates;
  /// The other processes that have a point, by own point; without points that are on this process
  /// alone.
  std::unordered_map<vtkIdType, std::vector<int>> Others;
  /// How many points of the whole surface belong to several pieces.
  vtkIdType Shared = 0;
  /// The points on borders of all pieces: process and number of each, one piece after the other.
  std::vector<int> BorderProcess;
  std::vector<vtkIdType> BorderNumber;
  /// The own points among them, as points of the polydata.
  std::vector<vtkIdType> OwnBorder;

  /// How points were matched: by global ids, or within a distance.
  bool UseIds = false;
  double Tolerance = 0.0;

  int OwnerOf(vtkIdType number) const;

  /// Empty where the surface can be worked on in its pieces, else why it cannot, as a part of a
  /// sentence. The same on all processes.
  std::string Reason;
};

/// Matches the borders. All processes call it; throws ProcessesError.
SharedPoints MatchBorders(
  Processes& processes, const Messages& messages, const SurfacePiece& piece);
}

#endif
