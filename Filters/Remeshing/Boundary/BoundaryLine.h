// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_BoundaryLine_h
#define DirectionFields_BoundaryLine_h

#include "Distance/ClosestPoints.h"
#include "Surface.h"
#include "Types.h"

#include <array>
#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// Points along the boundary, each joined with the next one, and the last one with the first if it
/// is closed.
struct BoundaryPath
{
  std::vector<Index> Points;
  bool IsClosed = false;

  std::size_t GetNumberOfEdges() const { return this->Points.size() - (this->IsClosed ? 0 : 1); }
};

/// The paths that edges form which one face only has. They end where other than two of these edges
/// meet, and at marked points.
/// @param edges    of all faces, each as often as faces have it, the lower point first
/// @param isMarked not 0 for points at which paths end
std::vector<BoundaryPath> BoundaryPathsOf(
  const std::vector<std::array<Index, 2>>& edges, const std::vector<char>& isMarked);

/// A path along the boundary of a surface. Places on it are numbers: k at point number k, and in
/// between on the edge to the next one; of closed ones n more is once around.
class BoundaryLine
{
public:
  BoundaryLine(const Surface& surface, BoundaryPath&& path);

  const std::vector<Index>& GetPoints() const { return this->Path.Points; }
  bool IsClosed() const { return this->Path.IsClosed; }
  Index GetNumberOfEdges() const { return static_cast<Index>(this->Path.GetNumberOfEdges()); }
  /// The point of the surface, and its position, at a whole place.
  Index PointAt(Index place) const;
  const Vector3& PositionAt(Index place) const { return this->Corners[this->InLine(place)]; }
  Vector3 PositionAt(double place) const;
  /// The value at a place of numbers at the points of the surface.
  double ValueAt(double place, const std::vector<double>& values) const;
  /// The length along the line from its first point to a place, and the place where that is.
  double LengthTo(double place) const;
  double PlaceAt(double length) const;
  /// The place closest to a position, from 0 on; whole where that is a point of the line.
  double Find(const Vector3& position) const;

private:
  /// The number in the line of a whole place.
  std::size_t InLine(Index place) const;

  BoundaryPath Path;
  /// The points' positions, with the first one again at the end of closed lines.
  std::vector<Vector3> Corners;
  /// From the first point to each of these.
  std::vector<double> Lengths;
  ClosestPoints Segments;
};

/// The boundary of a surface, points at the same place being one.
/// @param isUsed not 0 for the triangles that count
std::vector<BoundaryLine> BoundaryLinesOf(const Surface& surface, const std::vector<char>& isUsed);
}

#endif
