// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MultigridSystem.h"

#include "LeastSquaresPreconditioner.h"
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
/// Steps go on until the residual that they keep is below this part of the tolerance, and start again
/// from the true residual while that is above the tolerance.
constexpr double Margin = 0.9;
constexpr int MostSteps = 300;
constexpr int MostRestarts = 4;
/// In 1 / unit^2; above it the mass matrix is all that counts.
constexpr double LargestShift = 1e8;
/// What a residual is measured by is looked at, too, where so many steps have not been enough.
constexpr int ManySteps = 16;
/// Where the right-hand side is smaller than this part of ‖|K| |u|‖, that takes its place.
constexpr double RoundingScale = 1e-6;
/// Part of the inverse on the lowest sections that V-cycles may lack.
constexpr double NegligibleLack = 0.1;

std::vector<Index> Complement(const std::vector<Index>& given, Index count)
{
  std::vector<char> isGiven(count, 0);
  for (const Index v : given)
  {
    isGiven[v] = 1;
  }
  std::vector<Index> others;
  for (Index v = 0; v < count; ++v)
  {
    if (!isGiven[v])
    {
      others.push_back(v);
    }
  }
  return others;
}

/// Rows and columns of the vertices in the list, which ascends.
SparseMatrix Principal(const SparseMatrix& matrix, const std::vector<Index>& vertices)
{
  const auto n = static_cast<Index>(vertices.size());
  std::vector<Index> number(matrix.cols(), None);
  for (Index k = 0; k < n; ++k)
  {
    number[vertices[k]] = k;
  }
  SparseMatrix principal(n, n);
  principal.reserve(matrix.nonZeros());
  for (Index k = 0; k < n; ++k)
  {
    principal.startVec(k);
    for (SparseMatrix::InnerIterator it(matrix, vertices[k]); it; ++it)
    {
      if (number[it.row()] != None)
      {
        principal.insertBack(number[it.row()], k) = it.value();
      }
    }
  }
  principal.finalize();
  return principal;
}

ComplexVector Gathered(const ComplexVector& all, const std::vector<Index>& vertices)
{
  ComplexVector some(static_cast<Eigen::Index>(vertices.size()));
  ForRows(some,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        some[k] = all[vertices[k]];
      }
    });
  return some;
}

/// Zero elsewhere.
ComplexVector Scattered(
  const ComplexVector& some, const std::vector<Index>& vertices, Eigen::Index count)
{
  ComplexVector all = ComplexVector::Zero(count);
  ForRows(some,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        all[vertices[k]] = some[k];
      }
    });
  return all;
}

/// V-cycles in single precision for vectors in double precision, and what they lack of the inverse on
/// the lowest sections.
class Preconditioner
{
public:
  Preconditioner(const Multigrid& hierarchy, double shift, const LowestSections* lowest)
    : Cycles(hierarchy, std::max(0.0, shift))
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
      this->Lowest = lowest;
      this->PerValue = lack / value;
    }
  }
  bool IsUsable() const { return this->Cycles.IsUsable(); }

  /// z = B r; returns Re r^* z.
  /// @param size ‖r‖
  double Apply(const ComplexVector& r, double size, ComplexVector& z)
  {
    const auto rows = static_cast<Index>(r.size());
    this->Section.resize(2 * static_cast<std::size_t>(rows));
    Resize(z, rows);
    const WideSum products = ParallelSum<WideSum>(rows, VectorPiece, {},
      [&](Index begin, Index end)
      {
        WideSum sum;
        for (Index v = begin; v < end; ++v)
        {
          if (this->Lowest)
          {
            sum.Add({ this->Lowest->Vectors.data(), v }, r[v]);
          }
          this->Section[2 * v] = static_cast<float>(r[v].real() / size);
          this->Section[2 * v + 1] = static_cast<float>(r[v].imag() / size);
        }
        return sum;
      });
    this->Corrected.resize(this->Section.size());
    this->Cycles.Apply<1>(this->Section.data(), this->Corrected.data());
    Eigen::Array<double, Width, 1> real;
    Eigen::Array<double, Width, 1> imaginary;
    for (int b = 0; this->Lowest && b < Width; ++b)
    {
      real[b] = this->PerValue[b] * products.Value(b).real();
      imaginary[b] = this->PerValue[b] * products.Value(b).imag();
    }
    return ParallelSum<double>(rows, VectorPiece, 0.0,
      [&](Index begin, Index end)
      {
        double product = 0.0;
        for (Index v = begin; v < end; ++v)
        {
          z[v] = size * Complex(this->Corrected[2 * v], this->Corrected[2 * v + 1]);
          if (this->Lowest)
          {
            const CompactValues<Width> x(this->Lowest->Vectors.data(), v);
            const Eigen::Array<double, Width, 1> re = x.Real.cast<double>();
            const Eigen::Array<double, Width, 1> im = x.Imaginary.cast<double>();
            z[v] += Complex(
              (real * re - imaginary * im).sum(), (real * im + imaginary * re).sum());
          }
          product += r[v].real() * z[v].real() + r[v].imag() * z[v].imag();
        }
        return product;
      });
  }

private:
  Cycle Cycles;
  const LowestSections* Lowest = nullptr;
  /// What is added for each of the lowest sections.
  Eigen::ArrayXd PerValue;
  CompactSections Section;
  CompactSections Corrected;
};

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

/// Conjugate gradients on K u = b.
SystemSolution ConjugateGradients(const MultigridSystem& system, Preconditioner& preconditioner,
  const ComplexVector& b, ReducedBasis& solved)
{
  SystemSolution solution;
  const double norm = Norm(b);
  if (!(norm > 0.0))
  {
    solution.Vector = ComplexVector::Zero(b.size());
    return solution;
  }
  ReducedBasis::Guess guess = solved.Closest(system.EnergyFactor, system.MassFactor, b);
  solution.Vector = std::move(guess.Vector);
  if (guess.IsSolution)
  {
    solution.Residual = guess.Residual;
    return solution;
  }
  const CombinedMatrix matrix(system.Matrices, system.EnergyFactor, system.MassFactor);
  ComplexVector q;
  matrix.Multiply(solution.Vector, q);
  ComplexVector r = Uninitialized(b.size());
  ForRows(r,
    [&](Index begin, Index end)
    {
      r.segment(begin, end - begin) = b.segment(begin, end - begin) - q.segment(begin, end - begin);
    });
  double rest = Norm(r);
  if (!(rest < norm))
  {
    solution.Vector.setZero();
    r = b;
    rest = norm;
  }
  double size = norm;
  SectionProducts best;
  best.Vector = std::move(solution.Vector);
  solution.Residual = std::numeric_limits<double>::infinity();
  ComplexVector z;
  ComplexVector p;
  int steps = 0;
  for (int restart = 0; restart < MostRestarts && steps < MostSteps; ++restart)
  {
    ComplexVector u = best.Vector;
    double previous = 0.0;
    for (bool first = true; rest > Margin * system.Tolerance * size && steps < MostSteps &&
         system.GoOn();
         ++steps, first = false)
    {
      const double product = preconditioner.Apply(r, rest, z);
      if (first)
      {
        p.swap(z);
      }
      else
      {
        Combine(1.0, z, product / previous, p);
      }
      previous = product;
      const double step = product / matrix.Multiply(p, q);
      if (!(step > 0.0) || !std::isfinite(step))
      {
        break;
      }
      rest = std::sqrt(ParallelSum<double>(static_cast<Index>(r.size()), VectorPiece, 0.0,
        [&](Index begin, Index end)
        {
          double squares = 0.0;
          for (Index v = begin; v < end; ++v)
          {
            u[v] += step * p[v];
            r[v] -= step * q[v];
            squares += std::norm(r[v]);
          }
          return squares;
        }));
      if (steps == ManySteps)
      {
        size = Size(system, u, rest, norm);
      }
    }
    for (ComplexVector* const vector : { &r, &z, &p, &q })
    {
      // Their memory is what the products take.
      vector->resize(0);
    }
    SectionProducts products(system.Matrices, std::move(u));
    r = RestOf(system, products, b);
    rest = Norm(r);
    size = Size(system, products.Vector, rest, norm);
    const double relative = rest / size;
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

FreeSystem::FreeSystem(const Operators& operators, const std::vector<Index>& given, double scale)
  : Given(given)
  , Free(Complement(given, static_cast<Index>(operators.Energy.cols())))
  , Matrices([&]
      {
        Operators principal;
        principal.Energy = Principal(operators.Energy, this->Free);
        principal.Mass = Principal(operators.Mass, this->Free);
        return principal;
      }())
  , Hierarchy(this->Matrices, scale)
{
}

double MultigridSystem::Shift() const
{
  return this->MassFactor < LargestShift * this->EnergyFactor
    ? this->MassFactor / this->EnergyFactor
    : LargestShift;
}

ComplexVector MultigridSystem::Times(const ComplexVector& x) const
{
  return Product(this->Matrices, this->EnergyFactor, this->MassFactor, x);
}

SystemSolution MultigridSystem::Solve(const Multigrid& hierarchy, const LowestSections& lowest,
  const ComplexVector& rightHandSide, ReducedBasis& solved) const
{
  Preconditioner preconditioner(hierarchy, this->Shift(), &lowest);
  SystemSolution failed;
  failed.Vector = ComplexVector::Zero(rightHandSide.size());
  failed.Residual = 1.0;
  return preconditioner.IsUsable()
    ? ConjugateGradients(*this, preconditioner, rightHandSide, solved)
    : failed;
}

SystemSolution MultigridSystem::SolveConstrainedEnergy(FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given) const
{
  const Eigen::Index count = rightHandSide.size();
  SystemSolution solution;
  ComplexVector u = Scattered(given.Values, given.Vertices, count);
  if (freeSystem.Free.empty())
  {
    solution.Vector = std::move(u);
    return solution;
  }
  const ComplexVector b = Gathered(rightHandSide - this->Times(u), freeSystem.Free);
  Preconditioner preconditioner(freeSystem.Hierarchy, this->Shift(), nullptr);
  solution.Residual = 1.0;
  if (preconditioner.IsUsable())
  {
    const MultigridSystem inner{ freeSystem.Matrices, this->EnergyFactor, this->MassFactor,
      this->Tolerance, this->GoOn };
    const SystemSolution free = ConjugateGradients(inner, preconditioner, b, freeSystem.Solved);
    solution.Residual = free.Residual;
    u += Scattered(free.Vector, freeSystem.Free, count);
  }
  solution.Vector = std::move(u);
  return solution;
}

/// Conjugate gradients on the normal equations (CGLS, Björck 1996).
SystemSolution MultigridSystem::SolveConstrainedLeastSquares(const FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given) const
{
  SystemSolution solution;
  solution.Vector = Scattered(given.Values, given.Vertices, rightHandSide.size());
  if (freeSystem.Free.empty())
  {
    return solution;
  }
  const CombinedMatrix matrix(this->Matrices, this->EnergyFactor, this->MassFactor);
  ComplexVector q;
  matrix.Multiply(solution.Vector, q);
  const ComplexVector b = rightHandSide - q;
  // The gradient is K_f^* r: K r but at given vertices. Returns its norm.
  const auto findGradient = [&](const ComplexVector& r, ComplexVector& gradient)
  {
    matrix.Multiply(r, gradient);
    for (const Index v : given.Vertices)
    {
      gradient[v] = 0.0;
    }
    return Norm(gradient);
  };
  ComplexVector gradient;
  const double size = findGradient(b, gradient);
  if (!(size > 0.0))
  {
    return solution;
  }
  solution.Residual = 1.0;
  LeastSquaresPreconditioner preconditioner(
    matrix, freeSystem.Free, freeSystem.Hierarchy, std::max(0.0, this->Shift()));
  ComplexVector x = ComplexVector::Zero(b.size());
  int steps = 0;
  for (int restart = 0;
       preconditioner.IsUsable() && restart < MostRestarts && steps < MostSteps; ++restart)
  {
    ComplexVector better = x;
    ComplexVector r;
    matrix.Multiply(better, r);
    r -= b;
    preconditioner.Deflate(better, r);
    r = -r;
    double slope = findGradient(r, gradient);
    ComplexVector z;
    ComplexVector y;
    ComplexVector direction;
    // q = K_f direction
    double previous = 0.0;
    for (bool first = true; steps < MostSteps && this->GoOn(); ++steps, first = false)
    {
      const double product = preconditioner.Apply(gradient, slope, z);
      matrix.Multiply(z, y);
      preconditioner.Deflate(z, y);
      if (first)
      {
        direction.setZero(z.size());
        q.setZero(y.size());
      }
      const double keep = first ? 0.0 : product / previous;
      const double squares = ParallelSum<double>(static_cast<Index>(q.size()), VectorPiece, 0.0,
        [&](Index begin, Index end)
        {
          const Index length = end - begin;
          direction.segment(begin, length) =
            z.segment(begin, length) + keep * direction.segment(begin, length);
          q.segment(begin, length) = y.segment(begin, length) + keep * q.segment(begin, length);
          return q.segment(begin, length).squaredNorm();
        });
      previous = product;
      const double step = product / squares;
      if (!(step > 0.0) || !std::isfinite(step))
      {
        break;
      }
      ForRows(r,
        [&](Index begin, Index end)
        {
          const Index length = end - begin;
          better.segment(begin, length) += step * direction.segment(begin, length);
          r.segment(begin, length) -= step * q.segment(begin, length);
        });
      slope = findGradient(r, gradient);
      if (slope <= Margin * this->Tolerance * size)
      {
        break;
      }
    }
    matrix.Multiply(better, q);
    r = b - q;
    const double relative = findGradient(r, gradient) / size;
    const bool stalls = !(relative < 0.5 * solution.Residual);
    if (relative < solution.Residual)
    {
      solution.Residual = relative;
      x = std::move(better);
    }
    if (stalls || solution.Residual <= this->Tolerance)
    {
      break;
    }
  }
  solution.Vector += x;
  return solution;
}
}
