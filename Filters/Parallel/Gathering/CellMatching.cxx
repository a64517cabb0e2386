// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gathering/CellMatching.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// The corners of polygons in ascending order, one after another with each polygon's end.
struct SortedCorners
{
  std::vector<vtkIdType>::const_iterator Begin(std::size_t i) const
  {
    return this->Corners.begin() + static_cast<std::ptrdiff_t>(this->First[i]);
  }

  /// The same for cells of the same corners.
  std::uint64_t Key(std::size_t i) const
  {
    std::uint64_t key = 0;
    for (auto corner = this->Begin(i); corner != this->Begin(i + 1); ++corner)
    {
      key = (key ^ static_cast<std::uint64_t>(*corner)) * 0x9E3779B97F4A7C15ULL;
      key ^= key >> 29;
    }
    return key;
  }

  std::vector<vtkIdType> Corners;
  std::vector<std::size_t> First;
};

SortedCorners Sort(const GatheredCells& cells)
{
  SortedCorners sorted;
  sorted.Corners = cells.Corners.Values;
  sorted.First.assign(1, 0);
  for (vtkIdType i = 0; i < cells.First.back(); ++i)
  {
    const std::size_t begin = sorted.First.back();
    const std::size_t end =
      begin + static_cast<std::size_t>(cells.Sizes.Values.empty() ? 3 : cells.Sizes.Values[i]);
    std::sort(sorted.Corners.begin() + begin, sorted.Corners.begin() + end);
    sorted.First.push_back(end);
  }
  return sorted;
}

}

std::vector<vtkIdType> FindCells(const GatheredCells& cells, const GatheredCells& wanted)
{
  std::vector<vtkIdType> found(static_cast<std::size_t>(wanted.First.back()), -1);
  if (found.empty())
  {
    return found;
  }
  const SortedCorners all = Sort(cells);
  const SortedCorners copies = Sort(wanted);
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> copiesAt;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    copiesAt[copies.Key(k)].push_back(k);
  }
  for (std::size_t i = 0; i + 1 < all.First.size() && !copiesAt.empty(); ++i)
  {
    const auto at = copiesAt.find(all.Key(i));
    if (at == copiesAt.end())
    {
      continue;
    }
    // Copies of the same cell are found together and once.
    std::vector<std::size_t> others;
    for (const std::size_t k : at->second)
    {
      if (std::equal(all.Begin(i), all.Begin(i + 1), copies.Begin(k), copies.Begin(k + 1)))
      {
        found[k] = static_cast<vtkIdType>(i);
      }
      else
      {
        others.push_back(k);
      }
    }
    if (others.empty())
    {
      copiesAt.erase(at);
    }
    else
    {
      at->second = std::move(others);
    }
  }
  return found;
}
}
