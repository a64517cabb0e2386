// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripePieces_h
#define DirectionFields_StripePieces_h

#include "Stripes/StripeLevels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// A triangle, or a part of one, that levels run through as straight lines. Its points are numbers:
/// of crossings of edges, of points inside of triangles after those, and -1 - v of the node v.
struct StripePiece
{
  /// Counter-clockwise.
  std::array<std::int64_t, 3> Corners;
  /// The values at the corners, and the next lower whole numbers.
  std::array<double, 3> Value;
  std::array<std::int64_t, 3> Floor;
  std::array<StripeLevels::Side, 3> Sides;
  /// Whether all levels at the first side end in the last corner, which has no value; and whether
  /// one of the levels at the first side does, which the other sides do not cross.
  bool IsFan = false;
  bool EndsInCorner = false;

  /// Calls body(from, to) for each level, the higher values to the left of it; a level that ends in
  /// the last corner has that for one of them.
  template <typename Body>
  void ForLevels(const Body& body) const
  {
    const int big = this->BiggestSide();
    const std::int64_t count = this->Sides[big].Count();
    for (std::int64_t k = 0; k < count; ++k)
    {
      const std::int64_t here = this->Sides[big].Point(k);
      const std::int64_t there = this->IsFan ? this->Corners[2] : this->Across(big, count - 1 - k);
      if (this->Sides[big].Signed > 0)
      {
        body(there, here);
      }
      else
      {
        body(here, there);
      }
    }
  }

  /// A corner of a region between levels and its value.
  struct Place
  {
    std::int64_t Point;
    double Value;
  };
  /// Calls body(places, floor) for each region between levels: a convex polygon, counter-clockwise,
  /// and the next lower whole number of the values in it.
  template <typename Body>
  void ForRegions(std::vector<Place>& places, const Body& body) const
  {
    const int big = this->BiggestSide();
    const int next = (big + 1) % 3;
    const int last = (big + 2) % 3;
    const StripeLevels::Side& side = this->Sides[big];
    const std::int64_t count = side.Count();
    const std::int64_t up = side.Signed < 0 ? -1 : 1;
    for (std::int64_t k = 0; k <= count; ++k)
    {
      const std::int64_t floor = this->Floor[big] + up * k;
      const double before = static_cast<double>(up > 0 ? floor : floor + 1);
      const double after = static_cast<double>(up > 0 ? floor + 1 : floor);
      places.clear();
      places.push_back(k == 0 ? Place{ this->Corners[big], this->Value[big] }
                              : Place{ side.Point(k - 1), before });
      places.push_back(k == count ? Place{ this->Corners[next], this->Value[next] }
                                  : Place{ side.Point(k), after });
      if (this->IsFan)
      {
        places.push_back({ this->Corners[2], 0.5 * (places[0].Value + places[1].Value) });
        body(places, floor);
        continue;
      }
      if (k < count)
      {
        places.push_back({ this->Across(big, count - 1 - k), after });
      }
      if (k == this->Sides[last].Count())
      {
        places.push_back({ this->Corners[last], this->Value[last] });
      }
      if (k > 0)
      {
        places.push_back({ this->Across(big, count - k), before });
      }
      body(places, floor);
    }
  }

private:
  /// The side that all levels cross.
  int BiggestSide() const
  {
    int big = 0;
    for (int c = 1; c < 3 && !this->IsFan; ++c)
    {
      big = this->Sides[c].Count() > this->Sides[big].Count() ? c : big;
    }
    return big;
  }
  /// The k-th crossing of the two sides after the biggest one.
  std::int64_t Across(int big, std::int64_t k) const
  {
    const StripeLevels::Side& first = this->Sides[(big + 1) % 3];
    if (k < first.Count())
    {
      return first.Point(k);
    }
    k -= first.Count();
    if (this->EndsInCorner)
    {
      if (k == 0)
      {
        return this->Corners[2];
      }
      --k;
    }
    return this->Sides[(big + 2) % 3].Point(k);
  }
};

/// How the levels go on inside of triangles. Where a turn around a triangle gains nothing, it is
/// one piece. Where it gains n levels, these run to a point in its middle, around which the phase
/// turns n times: the triangle has a smaller one in its middle, in which they run straight to that
/// point, and pieces around that. Where a turn leads to the other sheet, the two sheets meet in the
/// middle: the phase at the corners and the one that is their mirror image have one value there,
/// and three pieces lie around it. Where that is a level, it ends there.
class StripePieces
{
public:
  explicit StripePieces(const StripeLevels& levels);

  /// A point inside of a triangle of the mesh.
  struct InnerPoint
  {
    Index Triangle;
    std::array<double, 3> Weights;
  };
  /// The middle of a triangle whose levels do not run straight through it.
  struct Center
  {
    Index Triangle;
    /// The number of levels gained by a turn; 0 where it leads to the other sheet.
    std::int64_t Gain;
    bool Flips;
    std::int64_t Point;
  };

  const StripeLevels& GetLevels() const { return this->Levels; }
  /// The centers in the order of their triangles.
  const std::vector<Center>& GetCenters() const { return this->Centers; }
  const std::vector<InnerPoint>& GetInnerPoints() const { return this->Points; }
  /// The pieces of the triangles that have a center, ordered by the centers.
  const std::vector<StripePiece>& GetPiecesAtCenters() const { return this->Pieces; }
  /// The center of each piece.
  const std::vector<Index>& GetPieceCenters() const { return this->PieceCenters; }

  /// Calls body(triangle, piece) for the triangles of a range that are one piece, of those on the
  /// front.
  template <typename Body>
  void ForStraight(Index begin, Index end, const Body& body) const
  {
    const WantedPhases& wanted = this->Levels.GetWanted();
    for (Index t = begin; t < end; ++t)
    {
      if (!wanted.GetMesh().IsFront(t))
      {
        continue;
      }
      const StripeLevels::Corners corners = this->Levels.At(t);
      if (IsStraight(corners))
      {
        body(t, this->Whole(t, corners));
      }
    }
  }

private:
  using Weights = std::array<double, 3>;
  using Side = StripeLevels::Side;
  struct End
  {
    Weights At;
    double Value;
    std::int64_t Floor;
  };

  static bool IsStraight(const StripeLevels::Corners& corners)
  {
    return !corners.Flips && corners.Gain() == 0;
  }
  StripePiece Whole(Index triangle, const StripeLevels::Corners& corners) const;
  void CutTurning(Index triangle, const StripeLevels::Corners& corners);
  void CutFlipping(Index triangle, const StripeLevels::Corners& corners);
  std::int64_t AddPoint(Index triangle, const Weights& weights);
  /// The crossings of a straight line through a triangle.
  Side AddSide(Index triangle, const End& from, const End& to);
  void AddPiece(const StripePiece& piece);

  const StripeLevels& Levels;
  std::vector<Center> Centers;
  std::vector<InnerPoint> Points;
  std::vector<StripePiece> Pieces;
  std::vector<Index> PieceCenters;
};
}

#endif
