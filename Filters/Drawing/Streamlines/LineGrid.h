// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LineGrid_h
#define DirectionFields_LineGrid_h

#include "Types.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// A place on a line.
struct LineSample
{
  Vector3 Position;
  /// Unit vectors: of the surface, and along the line.
  Vector3 Normal, Tangent;
  /// Where on its line it is.
  double Arc = 0.0;
};

/// Samples of lines on a surface, and quick answers to which are near. A hash table over cubic
/// cells, as large as the radius that is asked for at most; it grows by itself.
///
/// Only lines of one family see each other: those whose tangents, whichever way they run, are less
/// than half the angle apart that there is between families (90 degrees / families). So do only
/// places on the same side of the surface (normals up to 105 degrees apart), except where the
/// surface has one side only.
class LineGrid
{
public:
  LineGrid(const Vector3& origin, double cell, int families, bool isOneSided);

  void Insert(const LineSample& sample);

  /// Whether a sample of the family is nearer to a place than a radius, which is no larger than a
  /// cell, among those for which counts(sample) is true.
  template <typename Counts>
  bool IsNear(const LineSample& place, double radius, const Counts& counts) const
  {
    return this->Search(place, radius,
      [&](const LineSample& sample)
      { return this->SeesEachOther(sample, place) && counts(sample); });
  }
  bool IsNear(const LineSample& place, double radius) const
  {
    return this->Search(
      place, radius, [&](const LineSample& sample) { return this->SeesEachOther(sample, place); });
  }
  /// The same for tangents up to half as much again apart: samples of lines that see each other
  /// somewhere between their samples.
  bool IsNearWidely(const LineSample& place, double radius) const
  {
    return this->Search(place, radius,
      [&](const LineSample& sample)
      { return this->IsWithin(sample, place, this->LeastWideCosine); });
  }
  bool SeesEachOther(const LineSample& a, const LineSample& b) const
  {
    return this->IsWithin(a, b, this->LeastCosine);
  }

private:
  bool IsWithin(const LineSample& a, const LineSample& b, double leastCosine) const
  {
    return std::abs(a.Tangent.dot(b.Tangent)) > leastCosine &&
      (this->IsOneSided || a.Normal.dot(b.Normal) > -0.25);
  }

  using Cell = std::array<std::int64_t, 3>;
  Cell CellOf(const Vector3& position) const;
  std::size_t Slot(const Cell& cell) const;
  void Grow();

  template <typename Visit>
  bool Search(const LineSample& place, double radius, const Visit& visit) const
  {
    const Vector3 scaled = (place.Position - this->Origin) / this->CellSize;
    const double reach = radius / this->CellSize;
    Cell low;
    Cell middle;
    Cell high;
    for (int c = 0; c < 3; ++c)
    {
      low[c] = Floor(scaled[c] - reach);
      middle[c] = Floor(scaled[c]);
      high[c] = Floor(scaled[c] + reach);
    }
    // Where there is one near at all, most often it is in the same cell.
    if (this->SearchCell(middle, place, radius, visit))
    {
      return true;
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
    {
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
      {
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
        {
          const Cell cell = { x, y, z };
          if (cell != middle && this->SearchCell(cell, place, radius, visit))
          {
            return true;
          }
        }
      }
    }
    return false;
  }
  template <typename Visit>
  bool SearchCell(
    const Cell& cell, const LineSample& place, double radius, const Visit& visit) const
  {
    // A power of two, so that digits stay: squares of large and small lengths have no numbers.
    const double unit = std::ldexp(1.0, -std::ilogb(this->CellSize));
    const double most = unit * radius * (unit * radius);
    for (Index i = this->Heads[this->Slot(cell)]; i != None; i = this->Next[i])
    {
      const LineSample& sample = this->Samples[i];
      if ((unit * (sample.Position - place.Position)).squaredNorm() < most && visit(sample))
      {
        return true;
      }
    }
    return false;
  }
  static std::int64_t Floor(double scaled);

  Vector3 Origin;
  double CellSize;
  double LeastCosine, LeastWideCosine;
  bool IsOneSided;
  std::vector<Index> Heads;
  std::vector<Index> Next;
  std::vector<LineSample> Samples;
};
}

#endif
