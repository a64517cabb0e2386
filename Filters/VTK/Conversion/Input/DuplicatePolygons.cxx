// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/DuplicatePolygons.h"

#include "Conversion/Input/CellCorners.h"
#include "Conversion/Input/FieldArrays.h"

#include <DirectionFields/Support/RadixSort.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace DirectionFields
{
namespace
{
/// The finalizer of splitmix64 (Steele, Lea, Flood 2014).
std::uint64_t Scrambled(std::uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// The same number for polygons around the same points, and mostly different numbers for other
/// polygons. 0 for polygons of at most three corners.
template <typename Id>
std::uint32_t KeyOf(const Id* corners, vtkIdType size)
{
  std::uint64_t sum = 0;
  vtkIdType distinct = 0;
  std::uint64_t last = Scrambled(static_cast<std::uint64_t>(size > 0 ? corners[size - 1] : 0) + 1);
  for (vtkIdType k = 0; k < size; ++k)
  {
    const std::uint64_t corner = Scrambled(static_cast<std::uint64_t>(corners[k]) + 1);
    if (corner != last)
    {
      // An edge has no direction here.
      sum += Scrambled(corner + last);
      ++distinct;
    }
    last = corner;
  }
  return distinct > 3 ? std::max(static_cast<std::uint32_t>(sum >> 32), 1u) : 0;
}

/// The corners without consecutive repetitions.
template <typename Id>
std::vector<vtkIdType> Cycle(const Id* corners, vtkIdType size)
{
  std::vector<vtkIdType> cycle;
  for (vtkIdType k = 0; k < size; ++k)
  {
    if (corners[k] != corners[k == 0 ? size - 1 : k - 1])
    {
      cycle.push_back(corners[k]);
    }
  }
  return cycle;
}

/// Whether two cycles are the same from some corner on.
bool IsSame(const std::vector<vtkIdType>& one, const std::vector<vtkIdType>& other)
{
  if (one.size() != other.size())
  {
    return false;
  }
  std::vector<vtkIdType> twice = other;
  twice.insert(twice.end(), other.begin(), other.end());
  return std::search(twice.begin(), twice.end(), one.begin(), one.end()) != twice.end();
}
}

DuplicatePolygons::DuplicatePolygons(
  vtkCellArray* polygons, const std::function<bool(vtkIdType)>& isHidden)
{
  const auto number = static_cast<std::size_t>(polygons->GetNumberOfCells());
  WithCorners(polygons,
    [&](const auto* offsets, const auto* corners)
    {
      const auto sizeOf = [&](vtkIdType p)
      { return static_cast<vtkIdType>(offsets[p + 1] - offsets[p]); };
      LargeArray<Keyed<std::uint32_t>> keys(number);
      ForEachPieceOfTuples(number,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t p = begin; p < end; ++p)
          {
            const auto polygon = static_cast<vtkIdType>(p);
            keys[p] = { isHidden(polygon) ? 0 : KeyOf(corners + offsets[p], sizeOf(polygon)),
              static_cast<Index>(p) };
          }
        });
      RadixSort(keys, 32);
      const auto cycleOf = [&](Index p) { return Cycle(corners + offsets[p], sizeOf(p)); };
      // Polygons of one key that are no duplicates: hardly ever more than one.
      std::vector<Index> others;
      for (std::size_t begin = 0, end = 0; begin < number; begin = end)
      {
        while (end < number && keys[end].Value == keys[begin].Value)
        {
          ++end;
        }
        others.assign(1, keys[begin].Item);
        for (std::size_t k = begin + 1; k < end && keys[k].Value != 0; ++k)
        {
          const std::vector<vtkIdType> cycle = cycleOf(keys[k].Item);
          const std::vector<vtkIdType> backwards(cycle.rbegin(), cycle.rend());
          Earlier earlier;
          for (std::size_t i = 0; i < others.size() && earlier.Polygon < 0; ++i)
          {
            const std::vector<vtkIdType> first = cycleOf(others[i]);
            const bool isSame = IsSame(cycle, first);
            if (isSame || IsSame(backwards, first))
            {
              earlier = { others[i], !isSame };
            }
          }
          if (earlier.Polygon >= 0)
          {
            this->Duplicates[keys[k].Item] = earlier;
          }
          else
          {
            others.push_back(keys[k].Item);
          }
        }
      }
    });
}
}
