// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CombinedMatrix_h
#define DirectionFields_CombinedMatrix_h

#include "Matrices/CompactValues.h"
#include "Matrices/Operators.h"

#include <cstdint>
#include <vector>

namespace DirectionFields::Internal
{
/// K = a A + m M for many products, which are limited by the traffic of memory: what couples two
/// rows of one block is stored once, for both.
class CombinedMatrix
{
public:
  static constexpr Index BlockRows = 2048;

  CombinedMatrix(const Operators& operators, double a, double m);

  /// y = K x, in the storage that there is; returns Re x^* y.
  double Multiply(const ComplexVector& x, ComplexVector& y) const;
  /// The same; all is computed in double precision.
  double Multiply(const LargeArray<CompactComplex>& x, LargeArray<CompactComplex>& y) const;
  double Multiply(const LargeArray<CompactComplex>& x, ComplexVector& y) const;

private:
  template <typename Number, typename Sum>
  double MultiplyNumbers(const Number* all, Sum* to) const;

  struct OutsideEntry
  {
    /// Counted from the block's first row.
    Index Row;
    Index Column;
    Complex Value;
  };

  LargeArray<double> Diagonal;
  /// Couplings within block j: InsideBegin[j] to InsideEnd[j]. Rows and columns are counted from
  /// the block's first row.
  LargeArray<Index> InsideBegin;
  LargeArray<Index> InsideEnd;
  LargeArray<std::uint16_t> InsideRow;
  LargeArray<std::uint16_t> InsideColumn;
  LargeArray<Complex> InsideValue;
  /// The entries of each block in columns of other blocks.
  std::vector<std::vector<OutsideEntry>> Outside;
};
}

#endif
