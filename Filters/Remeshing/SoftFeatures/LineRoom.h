// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LineRoom_h
#define DirectionFields_LineRoom_h

#include "Types.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace DirectionFields::Internal
{
/// Says where lines on a surface run closely beside others.
class LineRoom
{
public:
  /// A place on a line.
  struct Place
  {
    Vector3 Position;
    /// Of the line and of the surface, of length 1.
    Vector3 Along;
    Vector3 Normal;
  };

  /// @param room    distance to both sides of a line that is to be free of others
  /// @param spacing of places on a line, at most
  LineRoom(double room, double spacing)
    : Room(room)
    , Spacing(spacing)
  {
  }

  /// Appends places on a straight piece of a line, as many as the spacing asks for.
  void AppendPlaces(const Vector3& start, const Vector3& end, const Vector3& normal,
    std::vector<Place>& places) const;
  /// @param number of the line
  void Add(const std::vector<Place>& line, Index number);
  /// The numbers of lines that were added and run beside these places, on the same side of the
  /// surface and in about the same direction, each once. Lines that they cross or continue are
  /// none.
  std::vector<Index> LinesBeside(const std::vector<Place>& line) const;
  /// The part of these places, from 0 to 1, that a line runs beside.
  double CrowdedPart(const std::vector<Place>& line) const;

private:
  using Cell = std::array<std::int64_t, 3>;
  Cell CellOf(const Vector3& position) const;
  /// Calls visit(number) for lines beside a place, until it returns true. Returns whether it did.
  template <typename Visit>
  bool AnyBeside(const Place& place, const Visit& visit) const;

  double Room;
  double Spacing;
  struct Numbered
  {
    Place At;
    Index Number;
  };
  std::map<Cell, std::vector<Numbered>> Cells;
};
}

#endif
