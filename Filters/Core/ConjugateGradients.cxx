// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ConjugateGradients.h"

#include "CombinedMatrix.h"
#include "OperatorProducts.h"
#include "VectorOperations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr int Width = SectionBlock::Width;
/// What a residual is measured by is looked at, too, where so many steps have not been enough.
constexpr int ManySteps = 16;
/// Where the right-hand side is smaller than this part of ‖|K| |u|‖, that takes its place.
constexpr double RoundingScale = 1e-6;
/// Part of the inverse on the lowest sections that V-cycles may lack.
constexpr double NegligibleLack = 0.1;

/// z = B r: V-cycles in single precision, and what they lack of the inverse on the lowest sections.
/// Works row by row within its user's loops, which are limited by the traffic of memory.
class Preconditioner
{
public:
  Preconditioner(const Multigrid& hierarchy, double shift, const LowestSections* lowest)
    : Cycles(hierarchy, std::max(0.0, shift))
    , Section(2 * static_cast<std::size_t>(hierarchy.GetLevels().front().Rows()))
    , Corrected(this->Section.size())
  {
    if (!lowest || lowest->Values.size() == 0 || !(lowest->Values.minCoeff() + shift > 0.0))
    {
      return;
    }
    const Eigen::ArrayXd value = lowest->Values.array() + shift;
    const Eigen::ArrayXd lack =
      1.0 - value / (lowest->Values.array() + this->Cycles.GetCoarsestShift());
    if (lack.maxCoeff() > NegligibleLack)
    {
      this->Lowest = lowest->Vectors.data();
      this->PerValue = lack / value;
    }
  }
  bool IsUsable() const { return this->Cycles.IsUsable(); }

  /// Sets a row of r.
  class Rows
  {
  public:
    /// @param sum of the rows' products with the lowest sections
    void Set(Index v, const Complex& r, WideSum& sum) const
    {
      this->Section[2 * v] = static_cast<float>(r.real() * this->PerScale);
      this->Section[2 * v + 1] = static_cast<float>(r.imag() * this->PerScale);
      if (this->Lowest)
      {
        sum.Add({ this->Lowest, v }, r);
      }
    }

  private:
    friend Preconditioner;
    float* Section;
    double PerScale;
    const float* Lowest;
  };
  /// @param scale about the norm of r
  Rows Begin(double scale)
  {
    this->Scale = scale;
    Rows rows;
    rows.Section = this->Section.data();
    rows.PerScale = 1.0 / scale;
    rows.Lowest = this->Lowest;
    return rows;
  }

  /// The rows of z.
  class Result
  {
  public:
    Complex operator()(Index v) const
    {
      Complex z = this->Scale * Complex(this->Corrected[2 * v], this->Corrected[2 * v + 1]);
      if (this->Lowest)
      {
        const CompactValues<Width> x(this->Lowest, v);
        const Numbers re = x.Real.cast<double>();
        const Numbers im = x.Imaginary.cast<double>();
        z += Complex((this->Real * re - this->Imaginary * im).sum(),
          (this->Real * im + this->Imaginary * re).sum());
      }
      return z;
    }

  private:
    friend Preconditioner;
    using Numbers = Eigen::Array<double, Width, 1>;
    const float* Corrected;
    double Scale;
    const float* Lowest;
    Numbers Real;
    Numbers Imaginary;
  };
  /// Once all rows are set.
  Result Apply(const WideSum& products)
  {
    this->Cycles.Apply<1>(this->Section.data(), this->Corrected.data());
    Result result;
    result.Corrected = this->Corrected.data();
    result.Scale = this->Scale;
    result.Lowest = this->Lowest;
    for (int b = 0; this->Lowest && b < Width; ++b)
    {
      result.Real[b] = this->PerValue[b] * products.Value(b).real();
      result.Imaginary[b] = this->PerValue[b] * products.Value(b).imag();
    }
    return result;
  }

private:
  Cycle Cycles;
  /// Null if V-cycles lack little.
  const float* Lowest = nullptr;
  /// What is added for each of the lowest sections.
  Eigen::ArrayXd PerValue;
  double Scale = 1.0;
  CompactSections Section;
  CompactSections Corrected;
};

/// Of the rows of a residual.
struct ResidualSums
{
  double Squares = 0.0;
  WideSum Lowest;

  ResidualSums& operator+=(const ResidualSums& other)
  {
    this->Squares += other.Squares;
    this->Lowest += other.Lowest;
    return *this;
  }
};

/// r -= step q, and sets the preconditioner's rows.
ResidualSums Update(
  Preconditioner& preconditioner, double scale, double step, const ComplexVector& q, ComplexVector& r)
{
  return ParallelSum<ResidualSums>(static_cast<Index>(r.size()), VectorPiece, {},
    [step, rows = preconditioner.Begin(scale), from = q.data(), to = r.data()](
      Index begin, Index end)
    {
      ResidualSums sums;
      for (Index v = begin; v < end; ++v)
      {
        const Complex rest = step == 0.0 ? to[v] : to[v] - step * from[v];
        to[v] = rest;
        rows.Set(v, rest, sums.Lowest);
        sums.Squares += std::norm(rest);
      }
      return sums;
    });
}

/// What the residual of u, of the given norm, is to be measured by: ‖b‖, or a part of what the terms
/// of K u add up to where rounding allows no better.
double Size(const MultigridSystem& system, const ComplexVector& u, double rest, double norm)
{
  return rest <= system.Tolerance * norm
    ? norm
    : std::max(norm,
        RoundingScale * system.EnergyFactor * SumOfMagnitudes(system.Matrices.Energy, u));
}

/// b - K u
ComplexVector RestOf(const MultigridSystem& system, const SectionProducts& u, const ComplexVector& b)
{
  ComplexVector rest = Uninitialized(b.size());
  ForRows(rest,
    [&](Index begin, Index end)
    {
      const Index length = end - begin;
      rest.segment(begin, length) = b.segment(begin, length) -
        system.EnergyFactor * u.Energy.segment(begin, length) -
        system.MassFactor * u.Mass.segment(begin, length);
    });
  return rest;
}

/// Directions in single precision: they only have to be nearly conjugate, residuals are those of what
/// is really added.
using CompactVector = LargeArray<CompactComplex>;

/// u += step p, then p = z / unit + keep p; the first time p = z / unit.
void Advance(const Preconditioner::Result& z, double unit, double step, double keep,
  ComplexVector& u, CompactVector& p)
{
  ForRows(u,
    [z, perUnit = 1.0 / unit, step, keep, solution = u.data(), direction = p.data()](
      Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Complex next = perUnit * z(v);
        if (keep == 0.0)
        {
          direction[v] = CompactComplex(next);
          continue;
        }
        const Complex before(direction[v]);
        solution[v] += step * before;
        direction[v] = CompactComplex(next + keep * before);
      }
    });
}

/// Steps from u on until the residual is small enough.
/// @param r     the residual of u
/// @param norm  of b
/// @param steps of all restarts
void Iterate(const MultigridSystem& system, const CombinedMatrix& matrix,
  Preconditioner& preconditioner, double norm, ComplexVector r, ComplexVector& u, int& steps)
{
  double rest = Norm(r);
  // Of directions, so that nothing leaves the range of single precision.
  const double unit = rest;
  double size = norm;
  CompactVector p(r.size());
  ComplexVector q;
  double step = 0.0;
  double previous = 0.0;
  ResidualSums sums = Update(preconditioner, rest, 0.0, q, r);
  for (; rest > ResidualMargin * system.Tolerance * size && steps < MostSteps && system.GoOn();
       ++steps)
  {
    const Preconditioner::Result z = preconditioner.Apply(sums.Lowest);
    const double product = ParallelSum<double>(static_cast<Index>(r.size()), VectorPiece, 0.0,
      [z, residual = r.data()](Index begin, Index end)
      {
        double sum = 0.0;
        for (Index v = begin; v < end; ++v)
        {
          const Complex value = z(v);
          sum += residual[v].real() * value.real() + residual[v].imag() * value.imag();
        }
        return sum;
      });
    Advance(z, unit, step, previous == 0.0 ? 0.0 : product / previous, u, p);
    previous = product;
    step = product / (unit * matrix.Multiply(p, q));
    if (!(step > 0.0) || !std::isfinite(step))
    {
      return;
    }
    sums = Update(preconditioner, rest, step, q, r);
    rest = std::sqrt(sums.Squares);
    if (steps == ManySteps)
    {
      size = Size(system, u, rest, norm);
    }
  }
  if (step > 0.0)
  {
    ForRows(u,
      [step, solution = u.data(), direction = p.data()](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          solution[v] += step * Complex(direction[v]);
        }
      });
  }
}
}

SystemSolution ConjugateGradients(const MultigridSystem& system, const Multigrid& hierarchy,
  const LowestSections* lowest, const ComplexVector& b, ReducedBasis& solved)
{
  SystemSolution solution;
  const double norm = Norm(b);
  Preconditioner preconditioner(hierarchy, system.Shift(), lowest);
  if (!preconditioner.IsUsable() || !(norm > 0.0))
  {
    solution.Vector = ComplexVector::Zero(b.size());
    solution.Residual = preconditioner.IsUsable() ? 0.0 : 1.0;
    return solution;
  }
  ReducedBasis::Guess guess = solved.Closest(system.EnergyFactor, system.MassFactor, b);
  SectionProducts best;
  best.Vector = std::move(guess.Vector);
  if (guess.IsSolution)
  {
    solution.Vector = std::move(best.Vector);
    solution.Residual = guess.Residual;
    return solution;
  }
  const CombinedMatrix matrix(system.Matrices, system.EnergyFactor, system.MassFactor);
  ComplexVector r;
  matrix.Multiply(best.Vector, r);
  Combine(1.0, b, -1.0, r);
  if (!(Norm(r) < norm))
  {
    best.Vector.setZero();
    r = b;
  }
  solution.Residual = std::numeric_limits<double>::infinity();
  int steps = 0;
  for (int restart = 0; restart < MostRestarts && steps < MostSteps; ++restart)
  {
    ComplexVector u = Copied(best.Vector);
    Iterate(system, matrix, preconditioner, norm, std::move(r), u, steps);
    SectionProducts products(system.Matrices, std::move(u));
    r = RestOf(system, products, b);
    const double rest = Norm(r);
    const double relative = rest / Size(system, products.Vector, rest, norm);
    const bool stalls = !(relative < 0.5 * solution.Residual);
    if (relative < solution.Residual)
    {
      solution.Residual = relative;
      best = std::move(products);
    }
    if (stalls || solution.Residual <= system.Tolerance)
    {
      break;
    }
  }
  if (solution.Residual <= system.Tolerance)
  {
    solved.Add(best, system.EnergyFactor, system.MassFactor, b, solution.Residual);
  }
  solution.Vector = std::move(best.Vector);
  solution.Energy = std::move(best.Energy);
  solution.Mass = std::move(best.Mass);
  return solution;
}
}
