// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LowerPattern_h
#define DirectionFields_LowerPattern_h

#include "Types.h"

#include <Eigen/SparseCore>

#include <cstdint>

namespace DirectionFields::Internal
{
/// Where the entries of the lower triangle of a matrix are. Those above the diagonal are skipped.
class LowerPattern
{
public:
  /// @param matrix must outlive the object
  template <typename Scalar>
  explicit LowerPattern(const Eigen::SparseMatrix<Scalar, Eigen::ColMajor, std::int32_t>& matrix)
    : Size(static_cast<Index>(matrix.cols()))
    , Starts(matrix.outerIndexPtr())
    , Counts(matrix.innerNonZeroPtr())
    , Rows(matrix.innerIndexPtr())
  {
  }

  Index GetSize() const { return this->Size; }
  /// Calls visit(row, column) for each entry, column by column.
  template <typename Visit>
  void ForEntries(const Visit& visit) const
  {
    for (Index column = 0; column < this->Size; ++column)
    {
      const std::int32_t begin = this->Starts[column];
      const std::int32_t end =
        this->Counts != nullptr ? begin + this->Counts[column] : this->Starts[column + 1];
      for (std::int32_t k = begin; k < end; ++k)
      {
        if (this->Rows[k] >= column)
        {
          visit(static_cast<Index>(this->Rows[k]), column);
        }
      }
    }
  }

private:
  Index Size;
  const std::int32_t* Starts;
  /// Null where the columns follow each other without gaps.
  const std::int32_t* Counts;
  const std::int32_t* Rows;
};

}

#endif
