// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RowSum_h
#define DirectionFields_RowSum_h

#include "Types.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace DirectionFields
{
/// Adds up the entries of one row by column.
template <typename Entry>
class RowSum
{
public:
  RowSum() { this->Resize(64); }

  Entry& operator[](Index column)
  {
    std::size_t at = this->Hash(column);
    while (this->Slots[at] != None && this->Row[this->Slots[at]].first != column)
    {
      at = (at + 1) & (this->Slots.size() - 1);
    }
    if (this->Slots[at] == None)
    {
      if (2 * this->Row.size() >= this->Slots.size())
      {
        this->Resize(2 * this->Slots.size());
        return (*this)[column];
      }
      this->Slots[at] = static_cast<Index>(this->Row.size());
      this->Row.emplace_back(column, Entry{});
    }
    return this->Row[this->Slots[at]].second;
  }

  /// Valid until the next use.
  /// @param sorted by column
  std::vector<std::pair<Index, Entry>>& Take(bool sorted)
  {
    for (const auto& entry : this->Row)
    {
      std::size_t at = this->Hash(entry.first);
      while (this->Slots[at] != None)
      {
        this->Slots[at] = None;
        at = (at + 1) & (this->Slots.size() - 1);
      }
    }
    if (sorted)
    {
      std::sort(this->Row.begin(), this->Row.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
    }
    return this->Row;
  }
  void Clear() { this->Row.clear(); }

private:
  std::size_t Hash(Index column) const
  {
    return (static_cast<std::uint32_t>(column) * 2654435769u) >> this->Shift;
  }
  void Resize(std::size_t slots)
  {
    this->Slots.assign(slots, None);
    this->Shift = 32;
    for (std::size_t size = slots; size > 1; size /= 2)
    {
      --this->Shift;
    }
    for (std::size_t k = 0; k < this->Row.size(); ++k)
    {
      std::size_t at = this->Hash(this->Row[k].first);
      while (this->Slots[at] != None)
      {
        at = (at + 1) & (slots - 1);
      }
      this->Slots[at] = static_cast<Index>(k);
    }
  }

  std::vector<Index> Slots;
  std::vector<std::pair<Index, Entry>> Row;
  int Shift = 32;
};
}

#endif
