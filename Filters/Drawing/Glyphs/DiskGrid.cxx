// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/DiskGrid.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Cell numbers stay far from the largest integer.
constexpr double MostCells = 1e17;

/// The cell itself, then its neighbours, nearest first: a near point is found early.
std::array<std::array<int, 3>, 27> MakeNeighbours()
{
  std::array<std::array<int, 3>, 27> cells;
  for (int i = 0; i < 27; ++i)
  {
    cells[i] = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
  }
  const auto distance = [](const std::array<int, 3>& c)
  { return std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]); };
  std::stable_sort(cells.begin(), cells.end(),
    [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return cells;
}

const std::array<std::array<int, 3>, 27> Neighbours = MakeNeighbours();
}

DiskGrid::DiskGrid(const Vector3& origin, double spacing, std::size_t expected)
  : Origin(origin)
  , Spacing(spacing)
{
  std::size_t size = 64;
  while (size < 2 * expected)
  {
    size *= 2;
  }
  this->Heads.assign(size, None);
  this->Places.reserve(expected);
}

DiskGrid::Cell DiskGrid::CellOf(const Vector3& scaled)
{
  Cell cell;
  for (int c = 0; c < 3; ++c)
  {
    cell[c] = static_cast<std::int64_t>(std::floor(std::clamp(scaled[c], -MostCells, MostCells)));
  }
  return cell;
}

std::size_t DiskGrid::Slot(const Cell& cell) const
{
  std::uint64_t hash = static_cast<std::uint64_t>(cell[0]) * 0x9e3779b97f4a7c15ull;
  hash ^= static_cast<std::uint64_t>(cell[1]) * 0xbf58476d1ce4e5b9ull;
  hash ^= static_cast<std::uint64_t>(cell[2]) * 0x94d049bb133111ebull;
  return static_cast<std::size_t>(hash ^ (hash >> 32)) & (this->Heads.size() - 1);
}

void DiskGrid::Link(Index point)
{
  Index& head = this->Heads[this->Slot(CellOf(this->Places[point].Position))];
  this->Places[point].Next = head;
  head = point;
}

void DiskGrid::Unlink(Index point)
{
  Index* link = &this->Heads[this->Slot(CellOf(this->Places[point].Position))];
  while (*link != point)
  {
    link = &this->Places[*link].Next;
  }
  *link = this->Places[point].Next;
}

void DiskGrid::Insert(const Vector3& position, const Eigen::Vector3f& normal)
{
  this->Places.push_back({ (position - this->Origin) / this->Spacing, normal, None });
  this->Link(this->GetNumberOfPoints() - 1);
}

void DiskGrid::Move(Index point, const Vector3& position, const Eigen::Vector3f& normal)
{
  this->Unlink(point);
  this->Places[point].Position = (position - this->Origin) / this->Spacing;
  this->Places[point].Normal = normal;
  this->Link(point);
}

template <typename Visit>
bool DiskGrid::Search(const Vector3& scaled, const Visit& visit) const
{
  const Cell home = CellOf(scaled);
  // Squared distances to the cells below, at and above the home cell along each axis.
  double gap[3][3];
  for (int c = 0; c < 3; ++c)
  {
    const double inside = scaled[c] - static_cast<double>(home[c]);
    gap[c][0] = inside * inside;
    gap[c][1] = 0.0;
    gap[c][2] = (1.0 - inside) * (1.0 - inside);
  }
  for (const auto& step : Neighbours)
  {
    if (gap[0][step[0] + 1] + gap[1][step[1] + 1] + gap[2][step[2] + 1] >= 1.0)
    {
      continue;
    }
    const Cell cell = { home[0] + step[0], home[1] + step[1], home[2] + step[2] };
    for (Index i = this->Heads[this->Slot(cell)]; i != None; i = this->Places[i].Next)
    {
      const double distance = (this->Places[i].Position - scaled).squaredNorm();
      if (distance < 1.0 && visit(i, distance))
      {
        return true;
      }
    }
  }
  return false;
}

bool DiskGrid::IsFree(const Vector3& position, const Eigen::Vector3f& normal, Index except) const
{
  return !this->Search((position - this->Origin) / this->Spacing,
    [&](Index i, double) { return i != except && IsSameSide(this->Places[i].Normal, normal); });
}

bool DiskGrid::IsEmptyAround(const Vector3& position) const
{
  return !this->Search(
    (position - this->Origin) / this->Spacing, [](Index, double) { return true; });
}

DiskGrid::Cell DiskGrid::CellAt(const Vector3& position) const
{
  return CellOf((position - this->Origin) / this->Spacing);
}

void DiskGrid::FindAround(const Cell& cell, std::vector<Index>& points) const
{
  points.clear();
  for (const auto& step : Neighbours)
  {
    const Cell other = { cell[0] + step[0], cell[1] + step[1], cell[2] + step[2] };
    for (Index i = this->Heads[this->Slot(other)]; i != None; i = this->Places[i].Next)
    {
      // Other cells can share the slot.
      if (CellOf(this->Places[i].Position) == other)
      {
        points.push_back(i);
      }
    }
  }
  std::sort(points.begin(), points.end());
}

Index DiskGrid::Nearest(
  const std::vector<Index>& points, const Vector3& position, const Eigen::Vector3f& normal) const
{
  const Vector3 scaled = (position - this->Origin) / this->Spacing;
  Index nearest = None;
  double least = 1.0;
  for (const Index i : points)
  {
    const double distance = (this->Places[i].Position - scaled).squaredNorm();
    if (distance < least && IsSameSide(this->Places[i].Normal, normal))
    {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}
}
