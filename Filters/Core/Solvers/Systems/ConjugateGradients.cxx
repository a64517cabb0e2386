// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/ConjugateGradients.h"

#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Multigrid/Cycle.h"

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

/// How much rounding in single precision takes from, or adds to, a residual each time it is updated.
constexpr double UpdateError = 1e-7;
/// Part of a residual that what has been added to it may be, before it is computed anew (H. van der
/// Vorst, Q. Ye, SIAM J. Sci. Comput. 22, 2000).
constexpr double MostError = 0.25;
/// Derivatives of the first solution that the next ones begin with, and their relative residual: more
/// of either saves no more steps than it costs.
constexpr int Derivatives = 2;
constexpr double DerivativeTolerance = 0.1;
/// Rows whose squares are added up in single precision.
constexpr Index FewRows = 256;

/// Residuals, directions and their products.
using CompactVector = LargeArray<CompactComplex>;

/// As real numbers, a piece of it.
Eigen::Map<Eigen::ArrayXf> Part(CompactVector& vector, Index begin, Index end)
{
  return { reinterpret_cast<float*>(vector.data() + begin), 2 * (end - begin) };
}

/// z = B r: V-cycles in single precision, and what they lack of the inverse on the lowest sections.
class Preconditioner
{
public:
  Preconditioner(const Hierarchy& hierarchy, double shift, const LowestSections& lowest)
    : Cycles(hierarchy, std::max(0.0, shift))
    , Corrected(hierarchy.GetLevels().front().Rows())
  {
    if (lowest.Values.size() == 0 || !(lowest.Values.minCoeff() + shift > 0.0))
    {
      return;
    }
    const Eigen::ArrayXd value = lowest.Values.array() + shift;
    const Eigen::ArrayXd lack =
      1.0 - value / (lowest.Values.array() + this->Cycles.GetCoarsestShift());
    if (lack.maxCoeff() > NegligibleLack)
    {
      this->Lowest = lowest.Vectors.data();
      this->PerValue = lack / value;
    }
  }
  bool IsUsable() const { return this->Cycles.IsUsable(); }

  /// The rows of z.
  class Result
  {
  public:
    Complex operator()(Index v) const
    {
      Complex z(this->Corrected[v]);
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
    /// Re r^* z
    double Product = 0.0;

  private:
    friend Preconditioner;
    using Numbers = Eigen::Array<double, Width, 1>;
    const CompactComplex* Corrected;
    const float* Lowest;
    Numbers Real;
    Numbers Imaginary;
  };
  /// @param r about of unit length
  Result Apply(const CompactVector& r)
  {
    Result result;
    this->Cycles.Apply<1>(reinterpret_cast<const float*>(r.data()),
      reinterpret_cast<float*>(this->Corrected.data()), 0, &result.Product);
    result.Corrected = this->Corrected.data();
    result.Lowest = this->Lowest;
    if (!this->Lowest)
    {
      return result;
    }
    const WideSum products = ParallelSum<WideSum>(static_cast<Index>(r.size()), VectorPiece, {},
      [lowest = this->Lowest, from = r.data()](Index begin, Index end)
      {
        WideSum sum;
        for (Index v = begin; v < end; ++v)
        {
          sum.Add({ lowest, v }, Complex(from[v]));
        }
        return sum;
      });
    for (int b = 0; b < Width; ++b)
    {
      result.Real[b] = this->PerValue[b] * products.Value(b).real();
      result.Imaginary[b] = this->PerValue[b] * products.Value(b).imag();
      result.Product += this->PerValue[b] * std::norm(products.Value(b));
    }
    return result;
  }

private:
  Cycle Cycles;
  /// Null if V-cycles lack little.
  const float* Lowest = nullptr;
  /// What is added for each of the lowest sections.
  Eigen::ArrayXd PerValue;
  CompactVector Corrected;
};

/// r -= step q; returns |r|.
double Update(double step, CompactVector& q, CompactVector& r)
{
  const auto squares = ParallelSum<double>(static_cast<Index>(r.size()), VectorPiece, 0.0,
    [&, factor = static_cast<float>(step)](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index first = begin; first < end; first += FewRows)
      {
        const Index last = std::min(end, first + FewRows);
        auto rest = Part(r, first, last);
        rest -= factor * Part(q, first, last);
        sum += rest.matrix().squaredNorm();
      }
      return sum;
    });
  return std::sqrt(squares);
}

/// What the residual of u, of the given norm, is to be measured by: ‖b‖, or a part of what the terms
/// of K u add up to where rounding allows no better.
double Size(const ShiftedSystem& system, const ComplexVector& u, double rest, double norm)
{
  return rest <= system.Tolerance * norm
    ? norm
    : std::max(norm,
        RoundingScale * system.EnergyFactor * SumOfMagnitudes(system.Matrices.Energy, u));
}

/// |b - K u|
double RestOf(const ShiftedSystem& system, const ComplexVector& b, const SectionProducts& u)
{
  const auto squares = ParallelSum<double>(static_cast<Index>(b.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      const Index length = end - begin;
      return (b.segment(begin, length) - system.EnergyFactor * u.Energy.segment(begin, length) -
        system.MassFactor * u.Mass.segment(begin, length))
        .squaredNorm();
    });
  return std::sqrt(squares);
}

/// K u
ComplexVector ProductOf(const ShiftedSystem& system, const SectionProducts& u)
{
  ComplexVector product = Uninitialized(u.Energy.size());
  ForRows(product,
    [&](Index begin, Index end)
    {
      const Index length = end - begin;
      product.segment(begin, length) = system.EnergyFactor * u.Energy.segment(begin, length) +
        system.MassFactor * u.Mass.segment(begin, length);
    });
  return product;
}

/// |b - product|
double RestOf(const ComplexVector& b, const ComplexVector& product)
{
  const auto squares = ParallelSum<double>(static_cast<Index>(b.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      const Index length = end - begin;
      return (b.segment(begin, length) - product.segment(begin, length)).squaredNorm();
    });
  return std::sqrt(squares);
}

/// u += step p, then p = z + keep p; the first time p = z.
void Advance(const Preconditioner::Result& z, double step, double keep, ComplexVector& u,
  CompactVector& p)
{
  ForRows(u,
    [z, step, keep, solution = u.data(), direction = p.data()](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Complex next = z(v);
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

/// u += step p
void Advance(double step, const CompactVector& p, ComplexVector& u)
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

/// compact = (b - r) / unit; returns its norm.
double SetRest(const ComplexVector& b, const ComplexVector& r, double unit, CompactVector& compact)
{
  const auto squares = ParallelSum<double>(static_cast<Index>(r.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        const Complex rest = (b[v] - r[v]) / unit;
        compact[v] = CompactComplex(rest);
        sum += std::norm(rest);
      }
      return sum;
    });
  return std::sqrt(squares);
}

/// Steps from u on until the residual is small enough.
/// @param product K u; overwritten
/// @param rest    the norm of b - K u
/// @param steps   of all restarts, up to mostSteps
void Iterate(const ShiftedSystem& system, const CombinedMatrix& matrix,
  Preconditioner& preconditioner, const ComplexVector& b, double norm, ComplexVector product,
  double rest, int mostSteps, ComplexVector& u, int& steps)
{
  // Of residuals and directions, so that nothing leaves the range of single precision.
  const double unit = rest;
  CompactVector r(b.size());
  CompactVector p(b.size());
  CompactVector q;
  double left = SetRest(b, product, unit, r);
  double error = UpdateError * left;
  double size = norm;
  // By which u has not been advanced yet.
  double step = 0.0;
  double previous = 0.0;
  while (unit * left > ResidualMargin * system.Tolerance * size && steps < mostSteps &&
    system.GoOn())
  {
    if (error > MostError * left)
    {
      Advance(step * unit, p, u);
      step = 0.0;
      matrix.Multiply(u, product);
      left = SetRest(b, product, unit, r);
      error = UpdateError * left;
      continue;
    }
    const Preconditioner::Result z = preconditioner.Apply(r);
    Advance(z, step * unit, previous == 0.0 ? 0.0 : z.Product / previous, u, p);
    previous = z.Product;
    step = z.Product / matrix.Multiply(p, q);
    if (!(step > 0.0) || !std::isfinite(step))
    {
      return;
    }
    left = Update(step, q, r);
    error += UpdateError * left;
    if (steps == ManySteps)
    {
      size = Size(system, u, unit * left, norm);
    }
    ++steps;
  }
  if (step > 0.0)
  {
    Advance(step * unit, p, u);
  }
}

/// Adds K^-1 M u, K^-1 M K^-1 M u ..., approximately: derivatives of a solution u by the factor of M,
/// but for their scale.
/// @param mostSteps for each
void AddDerivatives(const ShiftedSystem& system, const CombinedMatrix& matrix,
  Preconditioner& preconditioner, const SectionProducts& u, int mostSteps, ReducedBasis& solved)
{
  const ShiftedSystem rough{ system.Matrices, system.EnergyFactor, system.MassFactor,
    DerivativeTolerance, system.GoOn };
  SectionProducts last;
  for (int order = 1; order <= Derivatives; ++order)
  {
    const ComplexVector& b = order == 1 ? u.Mass : last.Mass;
    const double norm = Norm(b);
    ComplexVector t = Zeros(b.size());
    int steps = 0;
    Iterate(rough, matrix, preconditioner, b, norm, Zeros(b.size()), norm, mostSteps, t, steps);
    if (steps == 0 || !system.GoOn())
    {
      return;
    }
    last.Set(system.Matrices, std::move(t));
    solved.Add(last);
  }
}
}

SystemSolution ConjugateGradients(const ShiftedSystem& system, const Hierarchy& hierarchy,
  const LowestSections& lowest, const ComplexVector& b, ReducedBasis& solved)
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
  ComplexVector product;
  matrix.Multiply(best.Vector, product);
  double rest = RestOf(b, product);
  if (!(rest < norm))
  {
    best.Vector.setZero();
    product.setZero();
    rest = norm;
  }
  solution.Residual = std::numeric_limits<double>::infinity();
  int steps = 0;
  for (int restart = 0; restart < MostRestarts && steps < MostSteps; ++restart)
  {
    ComplexVector u = Copied(best.Vector);
    Iterate(
      system, matrix, preconditioner, b, norm, std::move(product), rest, MostSteps, u, steps);
    SectionProducts products(system.Matrices, std::move(u));
    rest = RestOf(system, b, products);
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
    product = ProductOf(system, best);
  }
  if (solution.Residual <= system.Tolerance)
  {
    solved.Add(best, system.EnergyFactor, system.MassFactor, b, solution.Residual);
    // Where K = M they are the solution itself.
    if (system.OthersFollow && solved.Size() == 1 && system.EnergyFactor > 0.0)
    {
      AddDerivatives(system, matrix, preconditioner, best, steps / 2, solved);
    }
  }
  solution.Vector = std::move(best.Vector);
  solution.Energy = std::move(best.Energy);
  solution.Mass = std::move(best.Mass);
  return solution;
}
}
