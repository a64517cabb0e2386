// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RowSum_h
#define DirectionFields_RowSum_h

#include "Types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace DirectionFields
{
/// Adds up the entries of one row by column. Which of them are new is hard to predict: there is no
/// branch that depends on it.
template <typename Entry>
class RowSum
{
public:
  RowSum()
    : Slots{}
    , Row(64, { None, Entry{} })
  {
  }

  Entry& operator[](Index column)
  {
    if (this->End + 1 == this->Row.size())
    {
      this->Row.resize(2 * this->Row.size(), { None, Entry{} });
    }
    std::uint32_t& slot = this->Slots[static_cast<std::uint32_t>(column) % SlotCount];
    const std::uint32_t isNew = this->Row[slot].first != column ? 1 : 0;
    const std::uint32_t at = slot + isNew * (this->End - slot);
    this->End += isNew;
    slot = at;
    this->Row[at].first = column;
    return this->Row[at].second;
  }

  /// Calls take(begin, end) with the entries, then forgets them. Columns that share a slot may come
  /// several times.
  template <typename TakeEntries>
  void Take(const TakeEntries& take)
  {
    take(this->Row.begin(), this->Row.begin() + this->End);
    this->Forget();
  }
  /// Each column once, in ascending order.
  template <typename TakeEntries>
  void TakeSorted(const TakeEntries& take)
  {
    const auto begin = this->Row.begin();
    const auto end = begin + this->End;
    std::sort(begin, end, [](const auto& a, const auto& b) { return a.first < b.first; });
    auto last = begin;
    for (auto entry = begin; entry != end; ++entry)
    {
      if (entry != begin && entry->first == last->first)
      {
        last->second += entry->second;
      }
      else if (entry != begin)
      {
        *++last = *entry;
      }
    }
    take(begin, begin == end ? end : last + 1);
    this->Forget();
  }

private:
  static constexpr std::uint32_t SlotCount = 1024;

  void Forget()
  {
    std::fill_n(this->Row.begin(), this->End, std::pair<Index, Entry>{ None, Entry{} });
    this->End = 0;
  }

  /// Where the last entry of the columns that share a slot is, or was.
  std::array<std::uint32_t, SlotCount> Slots;
  /// Those at the end are none.
  std::vector<std::pair<Index, Entry>> Row;
  std::uint32_t End = 0;
};
}

#endif
