// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Systems/LeastSquares.h"

#include "Solvers/Matrices/CombinedMatrix.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradientLoop.h"
#include "Solvers/Systems/ConjugateGradients.h"
#include "Solvers/Systems/LeastSquaresPreconditioner.h"
#include "Support/Free.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The steps are more on triangles of very different shapes, and there they grow with the number of
/// vertices. The iteration ends where MostSlowSteps have not halved the gradient.
constexpr int MostLeastSquaresSteps = 1200;
constexpr int MostSlowSteps = 60;

/// K_f^* K_f x_f = K_f^* b with b = (right-hand side) - K_c u_c. All vectors are over all vertices, those
/// of free values zero at the given ones.
struct NormalEquations
{
  NormalEquations(const ShiftedSystem& system, const FreeVertices& free,
    const ComplexVector& rightHandSide, const GivenValues& given)
    : Matrix(system.Matrices, system.EnergyFactor, system.MassFactor)
    , Free(free)
    , Given(given.Vertices)
  {
    ComplexVector q;
    this->Matrix.Multiply(free.Scattered(given), q);
    this->Right = rightHandSide - q;
    this->Size = this->FindGradient(this->Right, q);
    this->SmallSlope = ResidualMargin * system.Tolerance * this->Size;
  }

  /// gradient = K_f^* r. Returns its norm.
  double FindGradient(const ComplexVector& r, ComplexVector& gradient) const
  {
    this->Matrix.Multiply(r, gradient);
    for (const Index v : this->Given)
    {
      gradient[v] = 0.0;
    }
    return Norm(gradient);
  }
  /// ‖K_f^* (b - K_f x)‖ / ‖K_f^* b‖
  double Residual(const ComplexVector& x) const
  {
    ComplexVector q;
    this->Matrix.Multiply(x, q);
    const ComplexVector r = this->Right - q;
    return this->FindGradient(r, q) / this->Size;
  }

  CombinedMatrix Matrix;
  const FreeVertices& Free;
  const std::vector<Index>& Given;
  /// b
  ComplexVector Right;
  /// ‖K_f^* b‖
  double Size;
  /// A gradient of this norm is small enough.
  double SmallSlope;
};

/// Conjugate gradients from a given x on. The directions are deflated: what the preconditioner's coarse
/// level corrects is only noted, as coefficients, until Finish.
class NormalIteration
{
public:
  /// @param steps counts the steps of all iterations
  NormalIteration(const NormalEquations& equations, LeastSquaresPreconditioner& preconditioner,
    const Progress& progress, ComplexVector x, int& steps)
    : Equations(equations)
    , Preconditioner(preconditioner)
    , Listener(progress)
    , Solution(std::move(x))
    , Direction(this->Solution.size(), 0.0f)
    , Steps(steps)
    , LastHalved(steps)
  {
    this->Equations.Matrix.Multiply(this->Solution, this->Residual);
    this->Residual -= this->Equations.Right;
    this->Preconditioner.Correct(this->Preconditioner.Deflate(this->Residual), this->Solution);
    this->Residual = -this->Residual;
    this->Slope = this->Equations.FindGradient(this->Residual, this->Gradient);
    this->Halved = this->Slope;
    this->Unit = this->Slope;
  }

  bool GoesOn() const
  {
    if (this->Slope <= this->Equations.SmallSlope || this->Steps >= MostLeastSquaresSteps ||
      this->Steps - this->LastHalved > MostSlowSteps)
    {
      return false;
    }
    this->Listener.RequireToGoOn();
    return true;
  }

  double Precondition() { return this->Preconditioner.Apply(this->Gradient, this->Slope); }

  /// Takes the last step's part of the solution along in the same pass over the vectors.
  void SetDirection(double keep)
  {
    const std::vector<Index>& free = this->Equations.Free.GetVertices();
    ForRows(free,
      [vertices = free.data(), z = this->Preconditioner.GetResult().data(),
        perUnit = static_cast<float>(this->Slope / this->Unit), kept = static_cast<float>(keep),
        along = this->Pending * this->Unit, to = this->Direction.data(),
        solution = this->Solution.data()](Index begin, Index end)
      {
        for (Index k = begin; k < end; ++k)
        {
          const Index v = vertices[k];
          solution[v] += along * Complex(to[v]);
          to[v] = perUnit * CompactComplex(z[2 * k], z[2 * k + 1]) + kept * to[v];
        }
      });
    this->DeflatedSum += this->Pending * this->DeflatedDirection;
    this->Pending = 0.0;
  }

  double FindCurvature()
  {
    this->Equations.Matrix.Multiply(this->Direction, this->Product);
    this->DeflatedDirection = this->Unit * this->Preconditioner.Deflate(this->Product);
    if (this->DeflatedSum.size() == 0)
    {
      this->DeflatedSum.setZero(this->DeflatedDirection.size());
    }
    const double squares = RealDot(this->Product, this->Product);
    return this->Unit * this->Unit * squares;
  }

  void Advance(double step)
  {
    this->Pending = step;
    Combine(-step * this->Unit, this->Product, 1.0, this->Residual);
    this->Slope = this->Equations.FindGradient(this->Residual, this->Gradient);
    if (this->Slope <= 0.5 * this->Halved)
    {
      this->Halved = this->Slope;
      this->LastHalved = this->Steps;
    }
    ++this->Steps;
  }

  /// x with all steps and their correction. The iteration must not be used any more.
  ComplexVector Finish()
  {
    if (this->Pending > 0.0)
    {
      ForRows(this->Solution,
        [along = this->Pending * this->Unit, from = this->Direction.data(),
          solution = this->Solution.data()](Index begin, Index end)
        {
          for (Index v = begin; v < end; ++v)
          {
            solution[v] += along * Complex(from[v]);
          }
        });
      this->DeflatedSum += this->Pending * this->DeflatedDirection;
    }
    if (this->DeflatedSum.size() > 0)
    {
      this->Preconditioner.Correct(this->DeflatedSum, this->Solution);
    }
    return std::move(this->Solution);
  }

private:
  const NormalEquations& Equations;
  LeastSquaresPreconditioner& Preconditioner;
  const Progress& Listener;
  /// x, without what Pending still adds to it
  ComplexVector Solution;
  /// b - K_f x
  ComplexVector Residual;
  ComplexVector Gradient;
  /// Directions are kept over this unit, so that nothing leaves the range of single precision.
  double Unit;
  LargeArray<CompactComplex> Direction;
  /// K_f times the direction, deflated
  ComplexVector Product;
  /// Coefficients of what the direction and the sum of all steps still have to be corrected by.
  ComplexVector DeflatedDirection;
  ComplexVector DeflatedSum;
  /// The last step, which the solution has not taken yet; 0 for none.
  double Pending = 0.0;
  /// The norm of the gradient, and what it was when it was last halved.
  double Slope;
  double Halved;
  int& Steps;
  int LastHalved;
};

/// The solution that conjugate gradients find from x on.
ComplexVector Improved(const NormalEquations& equations, LeastSquaresPreconditioner& preconditioner,
  const Progress& progress, const ComplexVector& x, int& steps)
{
  NormalIteration iteration(equations, preconditioner, progress, x, steps);
  TakeConjugateGradientSteps(iteration);
  return iteration.Finish();
}
}

SystemSolution MinimizeResidualByMultigrid(const ShiftedSystem& system,
  const FreeSystem& freeSystem, const ComplexVector& rightHandSide, const GivenValues& given)
{
  SystemSolution solution;
  solution.Vector = freeSystem.Free.Scattered(given);
  if (freeSystem.Free.IsEmpty())
  {
    return solution;
  }
  const NormalEquations equations(system, freeSystem.Free, rightHandSide, given);
  if (!(equations.Size > 0.0))
  {
    return solution;
  }
  solution.Residual = 1.0;
  LeastSquaresPreconditioner preconditioner(
    LinearCombination(system.Matrices, system.EnergyFactor, system.MassFactor),
    freeSystem.Free.GetVertices(), freeSystem.Hierarchy, std::max(0.0, system.Shift()));
  ComplexVector x = ComplexVector::Zero(rightHandSide.size());
  int steps = 0;
  for (int restart = 0;
       preconditioner.IsUsable() && restart < MostRestarts && steps < MostLeastSquaresSteps;
       ++restart)
  {
    ComplexVector better = Improved(equations, preconditioner, system.Progress, x, steps);
    const double relative = equations.Residual(better);
    const bool stalls = !(relative < 0.5 * solution.Residual);
    if (relative < solution.Residual)
    {
      solution.Residual = relative;
      x = std::move(better);
    }
    if (stalls || solution.Residual <= system.Tolerance)
    {
      break;
    }
  }
  solution.Vector += x;
  return solution;
}
}
