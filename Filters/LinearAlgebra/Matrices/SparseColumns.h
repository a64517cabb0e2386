// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SparseColumns_h
#define DirectionFields_SparseColumns_h

#include "Support/Threads.h"
#include "Types.h"

namespace DirectionFields::Internal
{
/// Adds up conj(a) x; real and imaginary part at once.
class ConjugateSum
{
public:
  void Add(double real, double imaginary, const Complex& x)
  {
    const Eigen::Array2d both(x.real(), x.imag());
    this->ByReal += real * both;
    this->ByImaginary += imaginary * both;
  }
  Complex Value() const
  {
    return { this->ByReal[0] + this->ByImaginary[1], this->ByReal[1] - this->ByImaginary[0] };
  }

private:
  Eigen::Array2d ByReal = Eigen::Array2d::Zero();
  Eigen::Array2d ByImaginary = Eigen::Array2d::Zero();
};

/// The arrays of a sparse matrix by columns. Loops take copies of the pointers, so that the
/// compiler knows that writing values does not change them.
struct SparseColumns
{
  explicit SparseColumns(const SparseMatrix& matrix)
    : Begin(matrix.outerIndexPtr())
    , Row(matrix.innerIndexPtr())
    , Value(matrix.valuePtr())
  {
  }
  /// a_v^* x of column v
  Complex AdjointTimes(Index v, const Complex* x) const
  {
    ConjugateSum sum;
    for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
    {
      sum.Add(this->Value[k].real(), this->Value[k].imag(), x[this->Row[k]]);
    }
    return sum.Value();
  }
  const Index* Begin;
  const Index* Row;
  const Complex* Value;
};

/// Calls body(v) for each row. A row of a Hermitian matrix is the conjugate of the column.
template <typename Body>
void ForEachRow(Eigen::Index rows, const Body& body)
{
  constexpr Index pieceRows = 2048;
  ParallelFor(static_cast<Index>(rows), pieceRows,
    [&](Index begin, Index end)
    {
      // A copy of its own, which nothing that it writes can change.
      const Body local = body;
      for (Index v = begin; v < end; ++v)
      {
        local(v);
      }
    });
}
}

#endif
