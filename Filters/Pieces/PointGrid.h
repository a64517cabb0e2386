// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PointGrid_h
#define PointGrid_h

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
/// Points in the cells of a grid, to be found by their places within a tolerance. Few of them share
/// a cell.
class PointGrid
{
public:
  /// @param coordinates three of each point; must outlive the grid
  /// @param tolerance   is halved until few points share a cell; 0 means equal places
  PointGrid(const std::vector<double>& coordinates, double tolerance)
    : Coordinates(coordinates)
    , Within(tolerance)
  {
    this->Build();
    for (int halving = 0; this->MostInACell() > Few && this->Within > 0.0; ++halving)
    {
      this->Within = halving < MostHalvings ? 0.5 * this->Within : 0.0;
      this->Build();
    }
  }

  double Tolerance() const { return this->Within; }

  /// Calls body(k, squared distance in tolerances) for every point k within the tolerance of a
  /// place.
  template <typename Body>
  void ForEachNear(const double* place, const Body& body) const
  {
    std::array<std::int64_t, 3> lower;
    std::array<std::int64_t, 3> upper;
    for (int c = 0; c < 3; ++c)
    {
      lower[c] = this->Cell(place[c] - this->Within);
      upper[c] = this->Cell(place[c] + this->Within);
    }
    for (std::int64_t x = lower[0]; x <= upper[0]; ++x)
    {
      for (std::int64_t y = lower[1]; y <= upper[1]; ++y)
      {
        for (std::int64_t z = lower[2]; z <= upper[2]; ++z)
        {
          this->ForEachIn(Key({ x, y, z }), place, body);
        }
      }
    }
  }

private:
  using Entry = std::pair<std::uint64_t, vtkIdType>;
  static constexpr vtkIdType Few = 64;
  static constexpr int MostHalvings = 24;
  /// The edge of a cell in tolerances: most places are nearer than the tolerance to one cell only.
  static constexpr double CellSize = 16.0;

  std::int64_t Cell(double coordinate) const
  {
    if (this->Within > 0.0)
    {
      return static_cast<std::int64_t>(std::floor(coordinate / (CellSize * this->Within)));
    }
    // Equal places: the numbers' own bits, the same for both zeros.
    const double value = coordinate + 0.0;
    std::int64_t bits = 0;
    static_assert(sizeof(bits) == sizeof(value));
    std::copy_n(
      reinterpret_cast<const char*>(&value), sizeof(value), reinterpret_cast<char*>(&bits));
    return bits;
  }

  static std::uint64_t Key(const std::array<std::int64_t, 3>& cell)
  {
    std::uint64_t key = 0;
    for (const std::int64_t value : cell)
    {
      key = (key ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15ULL;
      key ^= key >> 29;
    }
    return key;
  }

  void Build()
  {
    const std::size_t points = this->Coordinates.size() / 3;
    this->Entries.clear();
    this->Entries.reserve(points);
    this->Filter.assign(std::max<std::size_t>(64, 16 * points) / 64 + 1, 0);
    for (std::size_t k = 0; k < points; ++k)
    {
      const double* const place = this->Coordinates.data() + 3 * k;
      const std::uint64_t key =
        Key({ this->Cell(place[0]), this->Cell(place[1]), this->Cell(place[2]) });
      this->Entries.emplace_back(key, static_cast<vtkIdType>(k));
      this->Filter[(key >> 6) % this->Filter.size()] |= std::uint64_t(1) << (key & 63);
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /// Points at exactly the same place count as one: halving does not part them.
  vtkIdType MostInACell() const
  {
    vtkIdType most = 0;
    vtkIdType count = 0;
    for (std::size_t i = 0; i < this->Entries.size(); ++i)
    {
      if (i == 0 || this->Entries[i].first != this->Entries[i - 1].first)
      {
        count = 1;
      }
      else if (!std::equal(this->Place(i), this->Place(i) + 3, this->Place(i - 1)))
      {
        ++count;
      }
      most = std::max(most, count);
    }
    return most;
  }

  const double* Place(std::size_t entry) const
  {
    return this->Coordinates.data() + 3 * this->Entries[entry].second;
  }

  template <typename Body>
  void ForEachIn(std::uint64_t key, const double* place, const Body& body) const
  {
    if ((this->Filter[(key >> 6) % this->Filter.size()] >> (key & 63) & 1) == 0)
    {
      return;
    }
    for (auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), Entry(key, -1));
         entry != this->Entries.end() && entry->first == key; ++entry)
    {
      const double* const point = this->Coordinates.data() + 3 * entry->second;
      // In tolerances, whose squares neither overflow nor vanish.
      const double unit = this->Within > 0.0 ? this->Within : 1.0;
      const double x = (point[0] - place[0]) / unit;
      const double y = (point[1] - place[1]) / unit;
      const double z = (point[2] - place[2]) / unit;
      const double squared = x * x + y * y + z * z;
      if (squared <= (this->Within > 0.0 ? 1.0 : 0.0))
      {
        body(entry->second, squared);
      }
    }
  }

  const std::vector<double>& Coordinates;
  double Within;
  /// The points sorted by the keys of their cells.
  std::vector<Entry> Entries;
  /// Bits by which most places that have no point are known.
  std::vector<std::uint64_t> Filter;
};
}

#endif
