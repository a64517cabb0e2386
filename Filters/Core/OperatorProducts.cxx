// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OperatorProducts.h"

#include "SectionBlock.h"
#include "Threads.h"
#include "VectorOperations.h"

#include <cmath>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr Index PieceRows = 2048;

/// Calls visit(column, value, k) for the entries of a column of a Hermitian matrix: the row's are
/// the conjugates.
template <typename Visit>
void ForEachEntry(const SparseMatrix& matrix, Index row, const Visit& visit)
{
  const Index* inner = matrix.innerIndexPtr();
  const Complex* values = matrix.valuePtr();
  for (Index k = matrix.outerIndexPtr()[row]; k < matrix.outerIndexPtr()[row + 1]; ++k)
  {
    visit(inner[k], values[k], k);
  }
}

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

template <typename Body>
void ForEachRow(const SparseMatrix& matrix, const Body& body)
{
  ParallelFor(static_cast<Index>(matrix.cols()), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index row = begin; row < end; ++row)
      {
        body(row);
      }
    });
}
}

ComplexVector Product(const SparseMatrix& matrix, const ComplexVector& x)
{
  ComplexVector y = Uninitialized(x.size());
  ForEachRow(matrix,
    [&](Index row)
    {
      ConjugateSum sum;
      ForEachEntry(matrix, row,
        [&](Index column, const Complex& value, Index)
        { sum.Add(value.real(), value.imag(), x[column]); });
      y[row] = sum.Value();
    });
  return y;
}

ComplexVector Product(const Operators& operators, double a, double m, const ComplexVector& x)
{
  ComplexVector y = Uninitialized(x.size());
  const Complex* mass = operators.Mass.valuePtr();
  ForEachRow(operators.Energy,
    [&](Index row)
    {
      ConjugateSum sum;
      ForEachEntry(operators.Energy, row,
        [&](Index column, const Complex& value, Index k)
        {
          sum.Add(a * value.real() + m * mass[k].real(), a * value.imag() + m * mass[k].imag(),
            x[column]);
        });
      y[row] = sum.Value();
    });
  return y;
}

CombinedMatrix::CombinedMatrix(const Operators& operators, double a, double m)
  : Pattern(operators.Energy)
  , Values(operators.Energy.nonZeros())
{
  const Complex* energy = operators.Energy.valuePtr();
  const Complex* mass = operators.Mass.valuePtr();
  ParallelFor(static_cast<Index>(this->Values.size()), 8 * PieceRows,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        this->Values[k] = a * energy[k] + m * mass[k];
      }
    });
}

double CombinedMatrix::Multiply(const ComplexVector& x, ComplexVector& y) const
{
  Resize(y, x.size());
  return ParallelSum<double>(static_cast<Index>(x.size()), PieceRows, 0.0,
    [&](Index begin, Index end)
    {
      double product = 0.0;
      for (Index row = begin; row < end; ++row)
      {
        ConjugateSum sum;
        ForEachEntry(this->Pattern, row,
          [&](Index column, const Complex&, Index k)
          { sum.Add(this->Values[k].real(), this->Values[k].imag(), x[column]); });
        y[row] = sum.Value();
        product += x[row].real() * y[row].real() + x[row].imag() * y[row].imag();
      }
      return product;
    });
}

double SumOfMagnitudes(const SparseMatrix& matrix, const ComplexVector& u)
{
  Eigen::VectorXd size(u.size());
  ParallelFor(static_cast<Index>(u.size()), PieceRows,
    [&](Index begin, Index end)
    { size.segment(begin, end - begin) = u.segment(begin, end - begin).cwiseAbs2().cwiseSqrt(); });
  return std::sqrt(ParallelSum<double>(static_cast<Index>(matrix.cols()), PieceRows, 0.0,
    [&](Index begin, Index end)
    {
      double squares = 0.0;
      for (Index row = begin; row < end; ++row)
      {
        double sum = 0.0;
        ForEachEntry(matrix, row,
          [&](Index column, const Complex& value, Index)
          { sum += std::sqrt(std::norm(value)) * size[column]; });
        squares += sum * sum;
      }
      return squares;
    }));
}

SectionProducts::SectionProducts(const Operators& operators, ComplexVector vector)
{
  this->Set(operators, std::move(vector));
}

void SectionProducts::Set(const Operators& operators, ComplexVector vector)
{
  this->Vector = std::move(vector);
  Resize(this->Energy, this->Vector.size());
  Resize(this->Mass, this->Vector.size());
  const Complex* mass = operators.Mass.valuePtr();
  ForEachRow(operators.Energy,
    [&](Index row)
    {
      ConjugateSum a;
      ConjugateSum m;
      ForEachEntry(operators.Energy, row,
        [&](Index column, const Complex& value, Index k)
        {
          a.Add(value.real(), value.imag(), this->Vector[column]);
          m.Add(mass[k].real(), mass[k].imag(), this->Vector[column]);
        });
      this->Energy[row] = a.Value();
      this->Mass[row] = m.Value();
    });
}

void Multiply(const Operators& operators, const float* x, float* ax, float* mx)
{
  constexpr int width = SectionBlock::Width;
  const Complex* mass = operators.Mass.valuePtr();
  ForEachRow(operators.Energy,
    [&](Index row)
    {
      Eigen::Array4d real = Eigen::Array4d::Zero();
      Eigen::Array4d imaginary = Eigen::Array4d::Zero();
      // Of the mass no digits cancel.
      CompactValues<width> m;
      ForEachEntry(operators.Energy, row,
        [&](Index column, const Complex& value, Index k)
        {
          const CompactValues<width> from(x, column);
          const Eigen::Array4d re = from.Real.cast<double>();
          const Eigen::Array4d im = from.Imaginary.cast<double>();
          real += value.real() * re + value.imag() * im;
          imaginary += value.real() * im - value.imag() * re;
          m.Add(CompactComplex(std::conj(mass[k])), from);
        });
      CompactValues<width> a;
      a.Real = real.cast<float>();
      a.Imaginary = imaginary.cast<float>();
      a.Store(ax, row);
      m.Store(mx, row);
    });
}
}
