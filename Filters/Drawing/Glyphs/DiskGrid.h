// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DiskGrid_h
#define DirectionFields_DiskGrid_h

#include "Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// Whether two surface points that are near in space are on the same side of the surface, by their
/// unit normals. Normals up to 105 degrees apart are: around the edge of a box there is one side,
/// a thin sheet has two.
inline bool IsSameSide(const Eigen::Vector3f& normal, const Eigen::Vector3f& other)
{
  return normal.dot(other) > -0.25f;
}

/// Points of a surface no two of which are nearer to each other than a spacing, and a quick search
/// for those near a place. A hash table over cubic cells of the spacing.
class DiskGrid
{
public:
  /// @param origin   any point, best near the others
  /// @param expected about how many points there will be
  DiskGrid(const Vector3& origin, double spacing, std::size_t expected);

  Index GetNumberOfPoints() const { return static_cast<Index>(this->Places.size()); }

  void Insert(const Vector3& position, const Eigen::Vector3f& normal);
  void Move(Index point, const Vector3& position, const Eigen::Vector3f& normal);

  /// No point but the given one is nearer than the spacing on the same side.
  bool IsFree(const Vector3& position, const Eigen::Vector3f& normal, Index except = None) const;
  /// No point is nearer than the spacing, on whatever side.
  bool IsEmptyAround(const Vector3& position) const;

  using Cell = std::array<std::int64_t, 3>;
  /// The cell of a place.
  Cell CellAt(const Vector3& position) const;
  /// All points that can be nearer than the spacing to a place in a cell, in ascending order.
  void FindAround(const Cell& cell, std::vector<Index>& points) const;
  /// The nearest of these that is nearer than the spacing on the same side; None without one. Of
  /// equally near ones the first.
  Index Nearest(
    const std::vector<Index>& points, const Vector3& position, const Eigen::Vector3f& normal) const;

private:
  /// A point, its position in units of the spacing.
  struct Place
  {
    Vector3 Position;
    Eigen::Vector3f Normal;
    Index Next;
  };
  static Cell CellOf(const Vector3& scaled);
  std::size_t Slot(const Cell& cell) const;
  void Link(Index point);
  void Unlink(Index point);
  /// Calls visit(point, squared distance) for all nearer than the spacing until it returns true.
  template <typename Visit>
  bool Search(const Vector3& scaled, const Visit& visit) const;

  Vector3 Origin;
  double Spacing;
  std::vector<Index> Heads;
  std::vector<Place> Places;
};
}

#endif
