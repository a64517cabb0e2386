// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/OperatorProducts.h"

#include "Matrices/SparseColumns.h"
#include "Matrices/VectorOperations.h"
#include "Support/Threads.h"

#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceRows = 2048;
}

ComplexVector Product(const SparseMatrix& matrix, const ComplexVector& x)
{
  ComplexVector y = Uninitialized(x.size());
  ForEachRow(x.size(),
    [a = SparseColumns(matrix), from = x.data(), to = y.data()](Index v)
    { to[v] = a.AdjointTimes(v, from); });
  return y;
}

ComplexVector Product(const Operators& operators, double a, double m, const ComplexVector& x)
{
  ComplexVector y = Uninitialized(x.size());
  ForEachRow(x.size(),
    [a, m, energy = SparseColumns(operators.Energy), mass = operators.Mass.valuePtr(),
      from = x.data(), to = y.data()](Index v)
    {
      ConjugateSum sum;
      for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
      {
        sum.Add(a * energy.Value[k].real() + m * mass[k].real(),
          a * energy.Value[k].imag() + m * mass[k].imag(), from[energy.Row[k]]);
      }
      to[v] = sum.Value();
    });
  return y;
}

SparseMatrix LinearCombination(const Operators& operators, double a, double m)
{
  SparseMatrix combined = operators.Energy;
  const Complex* energy = operators.Energy.valuePtr();
  const Complex* mass = operators.Mass.valuePtr();
  ParallelFor(static_cast<Index>(combined.nonZeros()), 8 * PieceRows,
    [=, to = combined.valuePtr()](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        to[k] = a * energy[k] + m * mass[k];
      }
    });
  return combined;
}

double SumOfMagnitudes(const SparseMatrix& matrix, const ComplexVector& u)
{
  Eigen::VectorXd size(u.size());
  ParallelFor(static_cast<Index>(u.size()), PieceRows,
    [&](Index begin, Index end)
    { size.segment(begin, end - begin) = u.segment(begin, end - begin).cwiseAbs2().cwiseSqrt(); });
  return std::sqrt(ParallelSum<double>(static_cast<Index>(matrix.cols()), PieceRows, 0.0,
    [a = SparseColumns(matrix), from = size.data()](Index begin, Index end)
    {
      double squares = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        double sum = 0.0;
        for (Index k = a.Begin[v]; k < a.Begin[v + 1]; ++k)
        {
          sum += std::sqrt(std::norm(a.Value[k])) * from[a.Row[k]];
        }
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
  ForEachRow(this->Vector.size(),
    [energy = SparseColumns(operators.Energy), mass = operators.Mass.valuePtr(),
      from = this->Vector.data(), toEnergy = this->Energy.data(),
      toMass = this->Mass.data()](Index v)
    {
      ConjugateSum a;
      ConjugateSum m;
      for (Index k = energy.Begin[v]; k < energy.Begin[v + 1]; ++k)
      {
        const Complex x = from[energy.Row[k]];
        a.Add(energy.Value[k].real(), energy.Value[k].imag(), x);
        m.Add(mass[k].real(), mass[k].imag(), x);
      }
      toEnergy[v] = a.Value();
      toMass[v] = m.Value();
    });
}
}
