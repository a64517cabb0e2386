// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OperatorProducts.h"

#include "SectionBlock.h"
#include "Threads.h"

#include <cmath>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr Index PieceRows = 2048;

/// Calls visit(row, column, value) for the entries of the rows, row after row. A column of a
/// Hermitian matrix is the conjugate of the row.
template <typename Visit>
void ForEachEntry(const SparseMatrix& matrix, Index row, const Visit& visit)
{
  const Index* inner = matrix.innerIndexPtr();
  const Complex* values = matrix.valuePtr();
  for (Index k = matrix.outerIndexPtr()[row]; k < matrix.outerIndexPtr()[row + 1]; ++k)
  {
    visit(inner[k], std::conj(values[k]), k);
  }
}

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
  ComplexVector y(x.size());
  ForEachRow(matrix,
    [&](Index row)
    {
      Complex sum = 0.0;
      ForEachEntry(matrix, row,
        [&](Index column, const Complex& value, Index) { sum += value * x[column]; });
      y[row] = sum;
    });
  return y;
}

ComplexVector Product(const Operators& operators, double a, double m, const ComplexVector& x)
{
  ComplexVector y(x.size());
  const Complex* mass = operators.Mass.valuePtr();
  ForEachRow(operators.Energy,
    [&](Index row)
    {
      Complex sum = 0.0;
      ForEachEntry(operators.Energy, row,
        [&](Index column, const Complex& value, Index k)
        { sum += (a * value + m * std::conj(mass[k])) * x[column]; });
      y[row] = sum;
    });
  return y;
}

double SumOfMagnitudes(const SparseMatrix& matrix, const ComplexVector& u)
{
  const Eigen::VectorXd size = u.cwiseAbs();
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
  : Vector(std::move(vector))
  , Energy(this->Vector.size())
  , Mass(this->Vector.size())
{
  const Complex* mass = operators.Mass.valuePtr();
  ForEachRow(operators.Energy,
    [&](Index row)
    {
      Complex a = 0.0;
      Complex m = 0.0;
      ForEachEntry(operators.Energy, row,
        [&](Index column, const Complex& value, Index k)
        {
          a += value * this->Vector[column];
          m += std::conj(mass[k]) * this->Vector[column];
        });
      this->Energy[row] = a;
      this->Mass[row] = m;
    });
}

void Multiply(const Operators& operators, const float* x, float* ax, float* mx)
{
  constexpr int width = SectionBlock::Width;
  const Complex* mass = operators.Mass.valuePtr();
  ForEachRow(operators.Energy,
    [&](Index row)
    {
      std::array<double, 2 * width> a{};
      // Of the mass no digits cancel.
      CompactValues<width> m;
      ForEachEntry(operators.Energy, row,
        [&](Index column, const Complex& value, Index k)
        {
          const float* from = x + static_cast<std::size_t>(2 * width) * column;
          for (int b = 0; b < width; ++b)
          {
            a[b] += value.real() * from[b] - value.imag() * from[width + b];
            a[width + b] += value.real() * from[width + b] + value.imag() * from[b];
          }
          m.Add(CompactComplex(std::conj(mass[k])), x, column);
        });
      const std::size_t place = static_cast<std::size_t>(2 * width) * row;
      for (int b = 0; b < 2 * width; ++b)
      {
        ax[place + b] = static_cast<float>(a[b]);
      }
      m.Store(mx, row);
    });
}
}
