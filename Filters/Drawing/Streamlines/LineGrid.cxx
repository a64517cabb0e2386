// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/LineGrid.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Cell numbers stay far from the largest integer.
constexpr double MostCells = 1e17;
constexpr std::size_t FewSlots = 16;
}

LineGrid::LineGrid(const Vector3& origin, double cell, int families, bool isOneSided)
  : Origin(origin)
  , CellSize(cell)
  // A little less than a right angle for a single family: it is the same line in whatever
  // direction.
  , LeastCosine(families == 1 ? -1.0 : std::cos(0.5 * Pi / families))
  , LeastWideCosine(families == 1 ? -1.0 : std::cos(0.75 * Pi / families))
  , IsOneSided(isOneSided)
  , Heads(FewSlots, None)
{
}

std::int64_t LineGrid::Floor(double scaled)
{
  return static_cast<std::int64_t>(std::floor(std::clamp(scaled, -MostCells, MostCells)));
}

LineGrid::Cell LineGrid::CellOf(const Vector3& position) const
{
  const Vector3 scaled = (position - this->Origin) / this->CellSize;
  return { Floor(scaled[0]), Floor(scaled[1]), Floor(scaled[2]) };
}

std::size_t LineGrid::Slot(const Cell& cell) const
{
  std::uint64_t hash = static_cast<std::uint64_t>(cell[0]) * 0x9e3779b97f4a7c15ull;
  hash ^= static_cast<std::uint64_t>(cell[1]) * 0xbf58476d1ce4e5b9ull;
  hash ^= static_cast<std::uint64_t>(cell[2]) * 0x94d049bb133111ebull;
  return static_cast<std::size_t>(hash ^ (hash >> 32)) & (this->Heads.size() - 1);
}

void LineGrid::Insert(const LineSample& sample)
{
  if (2 * this->Samples.size() >= this->Heads.size())
  {
    this->Grow();
  }
  Index& head = this->Heads[this->Slot(this->CellOf(sample.Position))];
  this->Next.push_back(head);
  head = static_cast<Index>(this->Samples.size());
  this->Samples.push_back(sample);
}

void LineGrid::Grow()
{
  this->Heads.assign(4 * this->Heads.size(), None);
  for (Index i = 0; i < static_cast<Index>(this->Samples.size()); ++i)
  {
    Index& head = this->Heads[this->Slot(this->CellOf(this->Samples[i].Position))];
    this->Next[i] = head;
    head = i;
  }
}
}
