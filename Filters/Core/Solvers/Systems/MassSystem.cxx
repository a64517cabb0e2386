// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/MassSystem.h"

#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradientLoop.h"

#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The relative residual: all digits that there are.
constexpr double Tolerance = 1e-14;
constexpr int MostMassSteps = 1000;

class MassIteration
{
public:
  MassIteration(const Operators& operators, const ComplexVector& b)
    : Mass(operators, 0.0, 1.0)
    , PerDiagonal(b.size())
    , Solution(Zeros(b.size()))
    , Residual(Copied(b))
    , Direction(Zeros(b.size()))
  {
    ForRows(b,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          this->PerDiagonal[v] = 1.0 / operators.Mass.coeff(v, v).real();
        }
      });
    this->Current = this->Update(0.0);
    this->SmallSquares = Tolerance * Tolerance * this->Current.Squares;
  }

  bool GoesOn() const
  {
    return this->Current.Squares > this->SmallSquares && this->Steps < MostMassSteps;
  }

  double Precondition() const { return this->Current.Scaled; }

  void SetDirection(double keep)
  {
    ForRows(this->Direction,
      [&](Index begin, Index end)
      {
        const Index length = end - begin;
        auto p = this->Direction.segment(begin, length);
        p = keep * p +
          (this->PerDiagonal.segment(begin, length) * this->Residual.segment(begin, length).array())
            .matrix();
      });
  }

  double FindCurvature() { return this->Mass.Multiply(this->Direction, this->Product); }

  void Advance(double step)
  {
    this->Current = this->Update(step);
    ++this->Steps;
  }

  ComplexVector Finish() { return std::move(this->Solution); }

private:
  struct Sums
  {
    double Squares = 0.0;
    /// r^* D^-1 r with the diagonal D.
    double Scaled = 0.0;
    Sums& operator+=(const Sums& other)
    {
      this->Squares += other.Squares;
      this->Scaled += other.Scaled;
      return *this;
    }
  };

  /// x += step p and r -= step q. Returns the sums of the new residual.
  Sums Update(double step)
  {
    return ParallelSum<Sums>(static_cast<Index>(this->Residual.size()), VectorPiece, {},
      [&](Index begin, Index end)
      {
        Sums sums;
        for (Index v = begin; v < end; ++v)
        {
          if (step != 0.0)
          {
            this->Solution[v] += step * this->Direction[v];
            this->Residual[v] -= step * this->Product[v];
          }
          const double square = std::norm(this->Residual[v]);
          sums.Squares += square;
          sums.Scaled += this->PerDiagonal[v] * square;
        }
        return sums;
      });
  }

  CombinedMatrix Mass;
  Eigen::ArrayXd PerDiagonal;
  ComplexVector Solution;
  ComplexVector Residual;
  ComplexVector Direction;
  /// M times the direction
  ComplexVector Product;
  Sums Current;
  double SmallSquares;
  int Steps = 0;
};
}

ComplexVector SolveMass(const Operators& operators, const ComplexVector& b)
{
  MassIteration iteration(operators, b);
  TakeConjugateGradientSteps(iteration);
  return iteration.Finish();
}
}
