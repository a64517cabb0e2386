// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CutPolygon_h
#define DirectionFields_CutPolygon_h

#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The rest of a polygon while ears are cut off, and its shape around the corners.
class CutPolygon
{
public:
  /// Coordinates in the plane are integers up to this size, so that their differences are exact.
  static constexpr double LargestCoordinate = 1125899906842624.0;
  /// The measure of a corner that is no ear.
  static constexpr double Worst = 1e300;
  /// Points nearer to a diagonal than this part of the polygon's size are on it up to rounding.
  static constexpr double Nearness = 1e-9;

  struct Place
  {
    double X;
    double Y;
    bool operator==(const Place& other) const { return this->X == other.X && this->Y == other.Y; }
  };

  /// @param corners in the cube from -1 to 1; must outlive this
  /// @param normal  unit vector along which the polygon is seen
  CutPolygon(const std::vector<Vector3>& corners, const Vector3& normal);

  Index Previous(Index i) const { return this->PreviousOf[i]; }
  Index Next(Index i) const { return this->NextOf[i]; }
  Index GetRemaining() const { return this->Remaining; }
  bool IsThere(Index i) const { return this->NextOf[i] != None; }
  const Place& At(Index i) const { return this->Places[i]; }
  void Remove(Index i);

  /// The sign of the area of a triangle of three corners, exactly: 1 if it is wound
  /// counter-clockwise.
  int Turn(Index a, Index b, Index c) const;
  /// Whether the inner angle of a corner is less than half a turn.
  bool IsConvex(Index i) const { return this->Turn(this->Previous(i), i, this->Next(i)) > 0; }
  /// The square of the perimeter of a corner's triangle over its area: the less, the better.
  double Measure(Index i) const;
  /// Whether the diagonal from an end of an ear to the other runs into the polygon there.
  bool OpensInwards(Index i) const;
  /// Whether a corner is in the way of the ear of another one.
  /// @param isWide also if it is beside the diagonal, by no more than rounding may have moved it
  bool Blocks(Index blocker, Index ear, bool isWide) const;

private:
  /// Whether a corner is near the line through two others.
  bool IsNear(Index a, Index b, Index corner) const;

  const std::vector<Vector3>& Corners;
  std::vector<Place> Places;
  std::vector<Index> PreviousOf;
  std::vector<Index> NextOf;
  Index Remaining;
};
}

#endif
