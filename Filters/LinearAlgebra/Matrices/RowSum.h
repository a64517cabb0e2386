// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RowSum_h
#define DirectionFields_RowSum_h

#include "Support/LargeArray.h"
#include "Support/Threads.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
/// Adds up the entries of one row of a sparse product: sum[column] is the entry of a column, zero
/// at first.
///
/// Whether a column has come before is hard to predict, and a branch that goes wrong takes longer
/// than the sum itself. So there is none. A column's slot is its number modulo SlotCount; a slot
/// says where in the row its latest column stands. If the row has another column there, the column
/// is new: it gets the place at the end of the row, and the slot points to it. Else it gets the
/// place that the slot says. Which of the two places is chosen by arithmetic. Slots need not be
/// cleared between rows: the entry that a slot of an earlier row points to has another column or
/// None, the column of all places from the end of the row on. Two columns that share a slot and
/// take turns get several places each; TakeSorted adds them up, and with SlotCount many times the
/// columns of a row this is rare.
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

  /// Calls take(begin, end) with the pairs (column, entry), then forgets them. Columns that share a
  /// slot may come several times.
  template <typename TakeEntries>
  void Take(const TakeEntries& take)
  {
    take(this->Row.begin(), this->Row.begin() + this->End);
    this->Forget();
  }
  /// The same with each column once, in ascending order.
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

  /// For each slot the place in this row, or an earlier one, of its latest column.
  std::array<std::uint32_t, SlotCount> Slots;
  /// The row has End entries; the column of later entries is None.
  std::vector<std::pair<Index, Entry>> Row;
  std::uint32_t End = 0;
};

/// The rows of a sparse matrix that are each added up by a RowSum, in pieces that run at once: how
/// many entries there are is known only once they have been made.
template <typename Entry>
struct SummedRows
{
  static constexpr Index PieceRows = 2048;

  /// The number of entries of each row.
  LargeArray<Index> Size;
  /// The entries, as (column, entry), of the rows of each piece one after the other.
  std::vector<std::vector<std::pair<Index, Entry>>> Pieces;

  /// Calls makeRow(row, sum), which adds the row's entries to the RowSum.
  /// @param sorted whether a row's entries are put in the order of their columns, each of which
  ///               comes once then; else columns may come several times
  template <typename MakeRow>
  SummedRows(Index count, bool sorted, const MakeRow& makeRow)
    : Size(count)
    , Pieces(NumberOfPieces(count, PieceRows))
  {
    constexpr Index firstRows = 64;
    ParallelFor(count, PieceRows,
      [&](Index begin, Index end)
      {
        RowSum<Entry> sum;
        auto& piece = this->Pieces[begin / PieceRows];
        for (Index row = begin; row < end; ++row)
        {
          if (row == begin + firstRows)
          {
            // The first rows tell about how much storage the piece will take.
            piece.reserve(piece.size() * (end - begin) / firstRows * 9 / 8);
          }
          makeRow(row, sum);
          const auto take = [&](auto first, auto last)
          {
            this->Size[row] = static_cast<Index>(last - first);
            piece.insert(piece.end(), first, last);
          };
          sorted ? sum.TakeSorted(take) : sum.Take(take);
        }
      });
  }

  /// Where each row begins if the entries of all are numbered through; at last the number of all.
  LargeArray<Index> Begin() const
  {
    LargeArray<Index> begin(this->Size.size() + 1);
    begin[0] = 0;
    std::partial_sum(this->Size.begin(), this->Size.end(), begin.begin() + 1);
    return begin;
  }

  /// Calls visit(row, k, (column, entry)) for the k-th entry of every row; pieces run at once.
  template <typename Visit>
  void ForEach(const Visit& visit) const
  {
    ParallelFor(static_cast<Index>(this->Size.size()), PieceRows,
      [&](Index begin, Index end)
      {
        auto entry = this->Pieces[begin / PieceRows].begin();
        for (Index row = begin; row < end; ++row)
        {
          for (Index k = 0; k < this->Size[row]; ++k)
          {
            visit(row, k, *entry++);
          }
        }
      });
  }
};
}

#endif
