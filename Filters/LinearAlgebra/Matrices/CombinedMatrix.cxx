// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/CombinedMatrix.h"

#include "Matrices/VectorOperations.h"
#include "Support/Threads.h"

#include <array>

namespace DirectionFields::Internal
{
namespace
{
/// Real and imaginary part.
using Parts = Eigen::Array2d;

template <typename Number>
Parts PartsOf(const Number& x)
{
  return { x.real(), x.imag() };
}

Parts Swapped(const Parts& x)
{
  return { x[1], x[0] };
}

/// sum[row] += a x and sum[column] += conj(a) x
struct Factor
{
  explicit Factor(const Complex& a)
    : Real(a.real())
    , Imaginary(-a.imag(), a.imag())
  {
  }
  Parts Times(const Parts& x) const { return this->Real * x + this->Imaginary * Swapped(x); }
  Parts ConjugateTimes(const Parts& x) const
  {
    return this->Real * x - this->Imaginary * Swapped(x);
  }
  double Real;
  Parts Imaginary;
};
}

CombinedMatrix::CombinedMatrix(const Operators& operators, double a, double m)
  : Diagonal(operators.Energy.cols())
  , Outside(NumberOfPieces(static_cast<Index>(operators.Energy.cols()), BlockRows))
{
  const auto rows = static_cast<Index>(operators.Energy.cols());
  const Index* outer = operators.Energy.outerIndexPtr();
  const Index* inner = operators.Energy.innerIndexPtr();
  const Complex* energy = operators.Energy.valuePtr();
  const Complex* mass = operators.Mass.valuePtr();
  // A block stores at most half of the entries beside the diagonal. One more place takes the last
  // entry that is written before it turns out to belong to the other half.
  const auto insideBegin = [=](Index begin)
  { return (outer[begin] - begin) / 2 + begin / BlockRows; };
  const auto blocks = static_cast<Index>(this->Outside.size());
  this->InsideBegin.resize(blocks);
  this->InsideEnd.resize(blocks);
  const auto size = static_cast<std::size_t>(outer[rows] - rows) / 2 + blocks;
  this->InsideRow.resize(size);
  this->InsideColumn.resize(size);
  this->InsideValue.resize(size);
  ParallelFor(rows, BlockRows,
    [=](Index begin, Index end)
    {
      std::uint16_t* const row = this->InsideRow.data();
      std::uint16_t* const column = this->InsideColumn.data();
      Complex* const inside = this->InsideValue.data();
      std::vector<OutsideEntry>& outside = this->Outside[begin / BlockRows];
      Index at = insideBegin(begin);
      this->InsideBegin[begin / BlockRows] = at;
      for (Index v = begin; v < end; ++v)
      {
        double diagonal = 0.0;
        for (Index k = outer[v]; k < outer[v + 1]; ++k)
        {
          const Index w = inner[k];
          // A row of a Hermitian matrix is the conjugate of the column.
          const Complex value = std::conj(a * energy[k] + m * mass[k]);
          if (w < begin || w >= end)
          {
            outside.push_back({ v - begin, w, value });
            continue;
          }
          // Each entry is written, and the next one overwrites it unless it is above the diagonal:
          // to tell the two apart first takes longer.
          row[at] = static_cast<std::uint16_t>(v - begin);
          column[at] = static_cast<std::uint16_t>(w - begin);
          inside[at] = value;
          at += w > v ? 1 : 0;
          diagonal = w == v ? value.real() : diagonal;
        }
        this->Diagonal[v] = diagonal;
      }
      this->InsideEnd[begin / BlockRows] = at;
    });
}

double CombinedMatrix::Multiply(const ComplexVector& x, ComplexVector& y) const
{
  Resize(y, static_cast<Eigen::Index>(this->Diagonal.size()));
  return this->MultiplyNumbers(x.data(), y.data());
}

double CombinedMatrix::Multiply(
  const LargeArray<CompactComplex>& x, LargeArray<CompactComplex>& y) const
{
  y.resize(this->Diagonal.size());
  return this->MultiplyNumbers(x.data(), y.data());
}

double CombinedMatrix::Multiply(const LargeArray<CompactComplex>& x, ComplexVector& y) const
{
  Resize(y, static_cast<Eigen::Index>(this->Diagonal.size()));
  return this->MultiplyNumbers(x.data(), y.data());
}

template <typename Number, typename Sum>
double CombinedMatrix::MultiplyNumbers(const Number* all, Sum* to) const
{
  const auto rows = static_cast<Index>(this->Diagonal.size());
  return ParallelSum<double>(rows, BlockRows, 0.0,
    [=, diagonal = this->Diagonal.data()](Index begin, Index end)
    {
      alignas(16) std::array<double, 2 * BlockRows> sums;
      const auto sum = [&](Index v) { return Eigen::Map<Parts, Eigen::Aligned16>(&sums[2 * v]); };
      const Number* const own = all + begin;
      for (Index v = 0; v < end - begin; ++v)
      {
        sum(v) = diagonal[begin + v] * PartsOf(own[v]);
      }
      const std::uint16_t* row = this->InsideRow.data();
      const std::uint16_t* column = this->InsideColumn.data();
      const Complex* value = this->InsideValue.data();
      const Index block = begin / BlockRows;
      for (Index k = this->InsideBegin[block], last = this->InsideEnd[block]; k < last; ++k)
      {
        const Factor factor(value[k]);
        const Index v = row[k];
        const Index w = column[k];
        sum(v) += factor.Times(PartsOf(own[w]));
        sum(w) += factor.ConjugateTimes(PartsOf(own[v]));
      }
      for (const OutsideEntry& entry : this->Outside[block])
      {
        sum(entry.Row) += Factor(entry.Value).Times(PartsOf(all[entry.Column]));
      }
      double product = 0.0;
      for (Index v = 0; v < end - begin; ++v)
      {
        const Parts total = sum(v);
        to[begin + v] = Sum(Complex(total[0], total[1]));
        product += (PartsOf(own[v]) * total).sum();
      }
      return product;
    });
}
}
