// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/PhaseDescent.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/SparseColumns.h"
#include "Matrices/VectorOperations.h"
#include "Sections/DoubleCover.h"
#include "Support/VectorMath.h"
#include "Systems/CyclePreconditioner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// No value is turned by more than this in a step, in radians.
constexpr double LongestTurn = 1.0;
/// A step that raises the energy is shortened by this factor, at most this many times.
constexpr double Shortening = 0.25;
constexpr int MostTrials = 4;

/// A sum and a maximum.
struct Measures
{
  double Sum = 0.0;
  double Other = 0.0;
  double Largest = 0.0;
  Measures& operator+=(const Measures& other)
  {
    this->Sum += other.Sum;
    this->Other += other.Other;
    this->Largest = std::max(this->Largest, other.Largest);
    return *this;
  }
};

/// Calls body(v) for each row and adds up the results.
template <typename Body>
Measures SumRows(Index rows, const Body& body)
{
  return ParallelSum<Measures>(rows, HeavyPiece, {},
    [&](Index begin, Index end)
    {
      // A copy of its own, which nothing that it writes can change.
      const Body local = body;
      Measures sums;
      for (Index v = begin; v < end; ++v)
      {
        sums += local(v);
      }
      return sums;
    });
}

/// Turns u by step times the phases.
void Turn(const ComplexVector& from, double step, const Eigen::VectorXd& phases, ComplexVector& to)
{
  ForRows(to,
    [&](Index begin, Index end)
    {
      ForCosinesAndSines(
        begin, end, [&](Index v) { return step * phases[v]; },
        [&](Index v, double cosine, double sine) { to[v] = from[v] * Complex(cosine, sine); });
    });
}
}

/// B r for sections over all vertices, those of free vertices taken and given.
class PhaseDescent::Cycles
{
public:
  Cycles(const PhaseDescent& descent, double shift)
    : Free(descent.Free)
    , Preconditioner(descent.Matrices, shift, {})
    , Right(descent.Matrices.GetLevels().front().Rows())
  {
  }
  bool IsUsable() const { return this->Preconditioner.IsUsable(); }

  /// Takes value(v) from each free vertex v and calls set(v, z) with the value z of B r there.
  template <typename Value, typename Set>
  void Apply(const Value& value, const Set& set)
  {
    const auto rows = static_cast<Index>(this->Right.size());
    const Index* const vertices = this->Free ? this->Free->GetVertices().data() : nullptr;
    const auto vertex = [vertices](Index row) { return vertices ? vertices[row] : row; };
    const double squares = ParallelSum<double>(rows, VectorPiece, 0.0,
      [&](Index begin, Index end)
      {
        double sum = 0.0;
        for (Index row = begin; row < end; ++row)
        {
          sum += std::norm(value(vertex(row)));
        }
        return sum;
      });
    if (!(squares > 0.0))
    {
      return;
    }
    // In single precision squares of small numbers would underflow.
    const double size = std::sqrt(squares);
    ParallelFor(rows, VectorPiece,
      [&](Index begin, Index end)
      {
        for (Index row = begin; row < end; ++row)
        {
          this->Right[row] = CompactComplex(value(vertex(row)) / size);
        }
      });
    const CyclePreconditioner::Result result = this->Preconditioner.Apply(this->Right);
    ParallelFor(rows, VectorPiece,
      [&](Index begin, Index end)
      {
        for (Index row = begin; row < end; ++row)
        {
          set(vertex(row), size * result(row));
        }
      });
  }

private:
  const FreeVertices* Free;
  CyclePreconditioner Preconditioner;
  CompactVector Right;
};

/// The state of conjugate gradients in the phases.
class PhaseDescent::Iteration
{
public:
  Iteration(const PhaseDescent& descent, double shift, ComplexVector& u)
    : Problem(descent.Problem)
    , Preconditioner(descent, shift)
    , Rows(descent.Problem.Rows())
    , U(u)
    , Turned(Uninitialized(Rows))
    , Slope(Rows)
    , Density(Rows)
    , Downhill(Eigen::VectorXd::Zero(Rows))
    , Direction(Eigen::VectorXd::Zero(Rows))
  {
    this->Energy = this->Differentiate(this->U);
  }
  bool IsUsable() const { return this->Preconditioner.IsUsable(); }
  double GetEnergy() const { return this->Energy; }

  /// False where the energy could not be lowered.
  bool Step()
  {
    if (!this->FindDirection())
    {
      return false;
    }
    const auto [curvature, along, largest] = this->Curvature();
    const double longest = LongestTurn / largest;
    double step = curvature > 0.0 ? std::min(along / curvature, longest) : longest;
    for (int trial = 0; trial < MostTrials; ++trial)
    {
      Turn(this->U, step, this->Direction, this->Turned);
      const double energy = this->Differentiate(this->Turned);
      if (energy < this->Energy)
      {
        this->Energy = energy;
        this->U.swap(this->Turned);
        return true;
      }
      step *= Shortening;
    }
    return false;
  }

private:
  /// Fills in Slope and Density at a section, and returns its energy.
  double Differentiate(const ComplexVector& at)
  {
    const SparseColumns matrix(this->Problem.Matrix);
    const Complex* const pull = this->Problem.Pull.size() > 0 ? this->Problem.Pull.data() : nullptr;
    const char* const given =
      this->Problem.IsGiven.empty() ? nullptr : this->Problem.IsGiven.data();
    return SumRows(this->Rows,
      [matrix, pull, given, u = at.data(), slope = this->Slope.data(),
        density = this->Density.data()](Index v)
      {
        const Complex p = pull ? pull[v] : Complex(0.0);
        const Complex gradient = std::conj(u[v]) * (matrix.AdjointTimes(v, u) - p);
        slope[v] = given && given[v] ? 0.0 : gradient.imag();
        density[v] = gradient.real();
        return Measures{ gradient.real() +
            (pull ? 2.0 * std::sqrt(std::norm(p)) - (std::conj(u[v]) * p).real() : 0.0),
          0.0, 0.0 };
      })
      .Sum;
  }

  /// The direction conjugate to the last one (Polak and Ribière). False where the energy does not
  /// fall along it.
  bool FindDirection()
  {
    const Eigen::VectorXd& slope = this->Slope;
    // The last slope along the next downhill direction can only be found with that.
    this->LastSlope.swap(this->SlopeOfLast);
    this->SlopeOfLast = slope;
    this->Preconditioner.Apply([&](Index v) { return Complex(0.0, slope[v]) * this->U[v]; },
      [&](Index v, const Complex& z) { this->Downhill[v] = -(std::conj(this->U[v]) * z).imag(); });
    this->MakeSymmetric();
    const bool first = this->LastSlope.size() == 0;
    const Measures products = SumRows(this->Rows,
      [downhill = this->Downhill.data(), now = slope.data(),
        last = first ? slope.data() : this->LastSlope.data()](Index v) {
        return Measures{ -now[v] * downhill[v], last[v] * downhill[v], 0.0 };
      });
    if (!(products.Sum > 0.0))
    {
      return false;
    }
    const double keep =
      first ? 0.0 : std::max(0.0, (products.Sum + products.Other) / this->LastDecrease);
    this->LastDecrease = products.Sum;
    ForRows(this->U,
      [&](Index begin, Index end)
      {
        auto part = this->Direction.segment(begin, end - begin);
        part = this->Downhill.segment(begin, end - begin) + keep * part;
        for (Index v = begin; v < end; ++v)
        {
          this->Turned[v] = Complex(0.0, this->Direction[v]) * this->U[v];
        }
      });
    return true;
  }

  /// The second derivative of half of the energy along the direction, the first one with its sign
  /// changed, and the largest phase.
  std::array<double, 3> Curvature() const
  {
    const Measures sums = SumRows(this->Rows,
      [matrix = SparseColumns(this->Problem.Matrix), tangent = this->Turned.data(),
        density = this->Density.data(), slope = this->Slope.data(),
        direction = this->Direction.data()](Index v)
      {
        return Measures{ (std::conj(tangent[v]) * matrix.AdjointTimes(v, tangent)).real() -
            direction[v] * direction[v] * density[v],
          -slope[v] * direction[v], std::abs(direction[v]) };
      });
    return { sums.Sum, sums.Other, sums.Largest };
  }

  /// On both sides of a cover the field turns in the same sense, seen from one of them.
  void MakeSymmetric()
  {
    if (!this->Problem.Component.IsCover)
    {
      return;
    }
    const TriangleMesh& mesh = this->Problem.Surface.Mesh;
    const Index first = this->Problem.Component.FirstVertex;
    for (Index v = 0; v < this->Rows; ++v)
    {
      const Index mirror = mesh.MirrorVertex(first + v) - first;
      if (v < mirror)
      {
        this->Downhill[v] = 0.5 * (this->Downhill[v] - this->Downhill[mirror]);
        this->Downhill[mirror] = -this->Downhill[v];
      }
    }
  }

  const UnitLengthProblem& Problem;
  Cycles Preconditioner;
  Index Rows;
  ComplexVector& U;
  /// A section in the direction of the step, then the one that the step leads to.
  ComplexVector Turned;
  /// Half of the derivatives of the energy by the phases; zero where they are given.
  Eigen::VectorXd Slope;
  Eigen::VectorXd SlopeOfLast;
  Eigen::VectorXd LastSlope;
  /// Re conj(u) (K u - p)
  Eigen::VectorXd Density;
  Eigen::VectorXd Downhill;
  Eigen::VectorXd Direction;
  double LastDecrease = 0.0;
  double Energy = 0.0;
};

PhaseDescent::PhaseDescent(
  const UnitLengthProblem& problem, const Hierarchy& hierarchy, const FreeVertices* free)
  : Problem(problem)
  , Matrices(hierarchy)
  , Free(free)
{
}

void PhaseDescent::Diffuse(double shift, int cycles, ComplexVector& u) const
{
  Cycles preconditioner(*this, shift);
  if (!preconditioner.IsUsable())
  {
    return;
  }
  ComplexVector x = Copied(u);
  for (int cycle = 0; cycle < cycles; ++cycle)
  {
    ComplexVector residual = this->Problem.Gradient(x);
    if (cycle > 0)
    {
      const ComplexVector way = x - u;
      const ComplexVector mass = Product(this->Problem.Mass, way);
      Combine(shift, mass, 1.0, residual);
    }
    preconditioner.Apply(
      [&](Index v) { return residual[v]; }, [&](Index v, const Complex& z) { x[v] -= z; });
  }
  if (this->Problem.Component.IsCover)
  {
    DoubleCover(this->Problem.Surface, this->Problem.Component, this->Problem.Degree).Symmetrize(x);
  }
  MakeUnit(x, &u);
  // Values that are given stay as they are, to the last bit.
  ForRows(u,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        u[v] = this->Problem.IsFree(v) ? x[v] : u[v];
      }
    });
}

int PhaseDescent::Polish(
  double shift, double tolerance, int mostSteps, const Progress& progress, ComplexVector& u) const
{
  Iteration iteration(*this, shift, u);
  int steps = 0;
  for (bool goesOn = iteration.IsUsable(); goesOn && steps < mostSteps; ++steps)
  {
    progress.RequireToGoOn();
    const double before = iteration.GetEnergy();
    goesOn = iteration.Step() && before - iteration.GetEnergy() >= tolerance * std::abs(before);
  }
  return steps;
}
}
