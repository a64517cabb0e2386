// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/LineRoom.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace DirectionFields::Internal
{
namespace
{
/// Lines that enclose a smaller angle than 45 degrees run beside each other.
constexpr double LeastProduct = 0.7071;
/// A line is beside a place, and does not continue through it, where it is to the side by this part
/// of what it is ahead.
constexpr double LeastAside = 0.5;
/// Cells beyond this are the same, so that numbers of cells fit.
constexpr double LastCell = 1e15;
}

void LineRoom::AppendPlaces(
  const Vector3& start, const Vector3& end, const Vector3& normal, std::vector<Place>& places) const
{
  constexpr double most = 1e5;
  const Vector3 along = (end - start).stableNormalized();
  const double wanted = std::ceil((end - start).stableNorm() / this->Spacing);
  const auto count = static_cast<Index>(std::clamp(wanted, 1.0, most));
  for (Index k = 0; k < count; ++k)
  {
    const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    places.push_back({ (1.0 - part) * start + part * end, along, normal });
  }
}

LineRoom::Cell LineRoom::CellOf(const Vector3& position) const
{
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double number = std::floor(position[axis] / this->Room);
    cell[axis] = static_cast<std::int64_t>(std::clamp(number, -LastCell, LastCell));
  }
  return cell;
}

void LineRoom::Add(const std::vector<Place>& line, Index number)
{
  for (const Place& place : line)
  {
    this->Cells[this->CellOf(place.Position)].push_back({ place, number });
  }
}

template <typename Visit>
bool LineRoom::AnyBeside(const Place& place, const Visit& visit) const
{
  const Cell middle = this->CellOf(place.Position);
  const auto isBeside = [&](const Place& other)
  {
    const Vector3 apart = other.Position - place.Position;
    const double ahead = std::abs(apart.dot(place.Along));
    const double aside = std::sqrt(std::max(0.0, apart.squaredNorm() - ahead * ahead));
    return std::abs(other.Along.dot(place.Along)) > LeastProduct &&
      other.Normal.dot(place.Normal) > 0.0 && ahead <= this->Spacing && aside < this->Room &&
      aside > LeastAside * ahead;
  };
  for (std::int64_t x = middle[0] - 1; x <= middle[0] + 1; ++x)
  {
    for (std::int64_t y = middle[1] - 1; y <= middle[1] + 1; ++y)
    {
      for (std::int64_t z = middle[2] - 1; z <= middle[2] + 1; ++z)
      {
        const auto found = this->Cells.find({ x, y, z });
        if (found != this->Cells.end() &&
          std::any_of(found->second.begin(), found->second.end(),
            [&](const Numbered& other) { return isBeside(other.At) && visit(other.Number); }))
        {
          return true;
        }
      }
    }
  }
  return false;
}

std::vector<Index> LineRoom::LinesBeside(const std::vector<Place>& line) const
{
  std::set<Index> numbers;
  for (const Place& place : line)
  {
    this->AnyBeside(place,
      [&](Index number)
      {
        numbers.insert(number);
        return false;
      });
  }
  return { numbers.begin(), numbers.end() };
}

double LineRoom::CrowdedPart(const std::vector<Place>& line) const
{
  const auto crowded = std::count_if(line.begin(), line.end(),
    [&](const Place& place) { return this->AnyBeside(place, [](Index) { return true; }); });
  return line.empty() ? 0.0 : static_cast<double>(crowded) / static_cast<double>(line.size());
}
}
