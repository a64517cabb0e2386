// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/ConjugateGradients.h"

#include "Matrices/CombinedMatrix.h"
#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"
#include "Systems/ConjugateGradientLoop.h"
#include "Systems/CyclePreconditioner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Number of steps after which the iteration also estimates how far rounding lets the residual
/// fall.
constexpr int ManySteps = 16;
/// Where the right-hand side is smaller than this part of ‖|K| |u|‖, the residual is measured by
/// that part.
constexpr double RoundingScale = 1e-6;
/// Each update of a residual in single precision leaves this part of it as an error.
constexpr double UpdateError = 1e-7;
/// The residual is computed anew where the errors of its updates have added up to this part of it
/// (H. van der Vorst, Q. Ye, SIAM J. Sci. Comput. 22, 2000).
constexpr double MostError = 0.25;
/// How many derivatives of the first solution the next ones begin with, and their relative
/// residual. More derivatives, or better ones, save no more steps than they cost.
constexpr int Derivatives = 2;
constexpr double DerivativeTolerance = 0.1;
/// The work of a step besides its cycle, by the entry of the matrix and by the row (see WorkLimit).
constexpr double WorkPerEntry = 3.0;
constexpr double WorkPerRow = 30.0;
/// The squares of this many rows are added up in single precision.
constexpr Index FewRows = 256;

/// A piece of a vector as real numbers.
Eigen::Map<Eigen::ArrayXf> Part(CompactVector& vector, Index begin, Index end)
{
  return { reinterpret_cast<float*>(vector.data() + begin), 2 * (end - begin) };
}

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

/// The scale of the residual of u, which has the given norm: ‖b‖, or, where rounding allows no
/// better, a part of the sum of the terms of K u.
double SizeOf(const ShiftedSystem& system, const ComplexVector& u, double rest, double norm)
{
  return rest <= system.Tolerance * norm
    ? norm
    : std::max(
        norm, RoundingScale * system.EnergyFactor * SumOfMagnitudes(system.Matrices.Energy, u));
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

/// compact = (b - product) / unit; returns its norm.
double SetRest(
  const ComplexVector& b, const ComplexVector& product, double unit, CompactVector& compact)
{
  const auto squares = ParallelSum<double>(static_cast<Index>(product.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        const Complex rest = (b[v] - product[v]) / unit;
        compact[v] = CompactComplex(rest);
        sum += std::norm(rest);
      }
      return sum;
    });
  return std::sqrt(squares);
}

/// K and the approximation of its inverse.
struct PreconditionedSystem
{
  const ShiftedSystem& System;
  const CombinedMatrix& Matrix;
  CyclePreconditioner& Inverse;
};

struct RightHandSide
{
  const ComplexVector& Vector;
  double Norm;
};

/// Where steps begin.
struct Start
{
  /// u
  ComplexVector Solution;
  /// K u
  ComplexVector Product;
  /// |b - K u|
  double Rest;
};

/// Conjugate gradients from a start until the residual is small enough. Residuals, directions and
/// their products are kept in single precision, over a unit that keeps them within its range.
class CompactIteration
{
public:
  /// @param steps counts the steps of all starts, up to mostSteps
  CompactIteration(const PreconditionedSystem& preconditioned, const RightHandSide& right,
    Start start, int mostSteps, int& steps)
    : System(preconditioned.System)
    , Matrix(preconditioned.Matrix)
    , Inverse(preconditioned.Inverse)
    , Right(right)
    , MostSteps(mostSteps)
    , Steps(steps)
    , FirstStep(steps)
    , StepWork(preconditioned.Inverse.Work() +
        WorkPerEntry * static_cast<double>(preconditioned.System.Matrices.Energy.nonZeros()) +
        WorkPerRow * static_cast<double>(right.Vector.size()))
    , Solution(std::move(start.Solution))
    , Product(std::move(start.Product))
    , Unit(start.Rest)
    , Size(right.Norm)
    , Residual(right.Vector.size())
    , Direction(right.Vector.size())
  {
    this->SetResidual();
  }

  bool GoesOn()
  {
    if (!this->IsStepWanted())
    {
      return false;
    }
    this->System.Progress.RequireToGoOn();
    if (this->Error > MostError * this->Left)
    {
      this->TakePending();
      this->Matrix.Multiply(this->Solution, this->Product);
      this->SetResidual();
    }
    return this->IsStepWanted();
  }

  double Precondition()
  {
    this->Corrected = this->Inverse.Apply(this->Residual);
    return this->Corrected.Product;
  }

  /// Lets the solution take the step before in the same pass over the vectors.
  void SetDirection(double keep)
  {
    ForRows(this->Solution,
      [z = this->Corrected, step = this->Pending * this->Unit, keep,
        solution = this->Solution.data(),
        direction = this->Direction.data()](Index begin, Index end)
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
    this->Pending = 0.0;
  }

  double FindCurvature() { return this->Matrix.Multiply(this->Direction, this->Image); }

  void Advance(double step)
  {
    this->Pending = step;
    this->Left = Update(step, this->Image, this->Residual);
    this->Error += UpdateError * this->Left;
    if (this->Steps == ManySteps)
    {
      this->Size = SizeOf(this->System, this->Solution, this->Unit * this->Left, this->Right.Norm);
    }
    ++this->Steps;
  }

  /// Returns the solution, which the iteration no longer has.
  ComplexVector Finish()
  {
    this->TakePending();
    return std::move(this->Solution);
  }

private:
  bool IsStepWanted() const
  {
    return this->Unit * this->Left > ResidualMargin * this->System.Tolerance * this->Size &&
      this->Steps < this->MostSteps && !this->IsTooMuchWork();
  }

  /// Whether the direct solver is the better choice. The residual begins with 1 in its unit.
  bool IsTooMuchWork() const
  {
    const double taken = this->StepWork * (this->Steps - this->FirstStep);
    return this->System.Limit &&
      !this->System.Limit->Allows(this->StepWork * this->Steps,
        RemainingWork(taken, 1.0, this->Left, this->System.Tolerance * this->Size / this->Unit));
  }

  /// From the product.
  void SetResidual()
  {
    this->Left = SetRest(this->Right.Vector, this->Product, this->Unit, this->Residual);
    this->Error = UpdateError * this->Left;
  }

  void TakePending()
  {
    if (this->Pending > 0.0)
    {
      ForRows(this->Solution,
        [step = this->Pending * this->Unit, solution = this->Solution.data(),
          direction = this->Direction.data()](Index begin, Index end)
        {
          for (Index v = begin; v < end; ++v)
          {
            solution[v] += step * Complex(direction[v]);
          }
        });
      this->Pending = 0.0;
    }
  }

  const ShiftedSystem& System;
  const CombinedMatrix& Matrix;
  CyclePreconditioner& Inverse;
  const RightHandSide Right;
  const int MostSteps;
  int& Steps;
  /// The steps of earlier starts, and the work of each (see WorkLimit).
  const int FirstStep;
  const double StepWork;
  /// u, without the terms that Pending still adds to it, and K u of the last time that the residual
  /// was computed
  ComplexVector Solution;
  ComplexVector Product;
  /// Residual and direction are kept over this.
  const double Unit;
  /// The scale of the residual.
  double Size;
  CompactVector Residual;
  /// z
  CyclePreconditioner::Result Corrected;
  CompactVector Direction;
  /// K times the direction
  CompactVector Image;
  /// The norm of the residual, and how large the errors of its updates may be.
  double Left;
  double Error;
  /// The last step, which the solution has not taken yet; 0 for none.
  double Pending = 0.0;
};

ComplexVector Iterate(const PreconditionedSystem& preconditioned, const RightHandSide& right,
  Start start, int mostSteps, int& steps)
{
  CompactIteration iteration(preconditioned, right, std::move(start), mostSteps, steps);
  TakeConjugateGradientSteps(iteration);
  return iteration.Finish();
}

/// Adds approximations of K^-1 M u and K^-1 M K^-1 M u, which are derivatives of a solution u by
/// the factor of M, up to their scale.
/// @param mostSteps the steps that each of them may take
void AddDerivatives(const PreconditionedSystem& preconditioned, const SectionProducts& u,
  int mostSteps, ReducedBasis& solved)
{
  ShiftedSystem rough = preconditioned.System;
  rough.Tolerance = DerivativeTolerance;
  SectionProducts last;
  for (int order = 1; order <= Derivatives; ++order)
  {
    const ComplexVector& b = order == 1 ? u.Mass : last.Mass;
    const double norm = Norm(b);
    int steps = 0;
    ComplexVector derivative = Iterate({ rough, preconditioned.Matrix, preconditioned.Inverse },
      { b, norm }, { Zeros(b.size()), Zeros(b.size()), norm }, mostSteps, steps);
    if (steps == 0)
    {
      return;
    }
    last.Set(rough.Matrices, std::move(derivative));
    solved.Add(last);
  }
}

/// The start at u, or at zero where that is closer.
Start StartAt(ComplexVector u, const CombinedMatrix& matrix, const RightHandSide& right)
{
  Start start;
  start.Solution = std::move(u);
  matrix.Multiply(start.Solution, start.Product);
  start.Rest = RestOf(right.Vector, start.Product);
  if (!(start.Rest < right.Norm))
  {
    start.Solution.setZero();
    start.Product.setZero();
    start.Rest = right.Norm;
  }
  return start;
}

/// Starts again from the true residual while that is too large and gets smaller.
/// @param best gets the best solution
/// @return the residual of that relative to its size
double IterateWithRestarts(const PreconditionedSystem& preconditioned, const RightHandSide& right,
  Start start, int& steps, SectionProducts& best)
{
  const ShiftedSystem& system = preconditioned.System;
  double residual = std::numeric_limits<double>::infinity();
  for (int restart = 0; restart < MostRestarts && steps < MostSteps; ++restart)
  {
    SectionProducts products(
      system.Matrices, Iterate(preconditioned, right, std::move(start), MostSteps, steps));
    const double rest = RestOf(system, right.Vector, products);
    const double relative = rest / SizeOf(system, products.Vector, rest, right.Norm);
    const bool stalls = !(relative < 0.5 * residual);
    if (relative < residual)
    {
      residual = relative;
      best = std::move(products);
    }
    if (stalls || residual <= system.Tolerance)
    {
      break;
    }
    start = { Copied(best.Vector), ProductOf(system, best), rest };
  }
  return residual;
}
}

SystemSolution ConjugateGradients(const ShiftedSystem& system, const Hierarchy& hierarchy,
  const LowestSections& lowest, const ComplexVector& b, ReducedBasis& solved)
{
  SystemSolution solution;
  const RightHandSide right{ b, Norm(b) };
  CyclePreconditioner preconditioner(hierarchy, system.Shift(), lowest);
  if (!preconditioner.IsUsable() || !(right.Norm > 0.0))
  {
    solution.Vector = ComplexVector::Zero(b.size());
    solution.Residual = preconditioner.IsUsable() ? 0.0 : 1.0;
    return solution;
  }
  ReducedBasis::Guess guess = solved.Closest(system.EnergyFactor, system.MassFactor, b);
  if (guess.IsSolution)
  {
    solution.Vector = std::move(guess.Vector);
    solution.Residual = guess.Residual;
    return solution;
  }
  const CombinedMatrix matrix(system.Matrices, system.EnergyFactor, system.MassFactor);
  const PreconditionedSystem preconditioned{ system, matrix, preconditioner };
  int steps = 0;
  SectionProducts best;
  solution.Residual = IterateWithRestarts(
    preconditioned, right, StartAt(std::move(guess.Vector), matrix, right), steps, best);
  if (solution.Residual <= system.Tolerance)
  {
    solved.Add(best, system.EnergyFactor, system.MassFactor, b, solution.Residual);
    // Where K = M the derivatives are multiples of the solution.
    if (system.OthersFollow && solved.Size() == 1 && system.EnergyFactor > 0.0)
    {
      AddDerivatives(preconditioned, best, steps / 2, solved);
    }
  }
  solution.Vector = std::move(best.Vector);
  solution.Energy = std::move(best.Energy);
  solution.Mass = std::move(best.Mass);
  return solution;
}
}
