// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/JacobiDavidson.h"

#include "Eigenpairs/DeflatedGradients.h"
#include "Eigenpairs/NestedIteration.h"
#include "Eigenpairs/RitzSpace.h"
#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Width = SectionBlock::Width;
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// How far one Jacobi-Davidson step solves its correction equation: with the eigenvalue that is in
/// the equation, to go further is of no use. Besides its V-cycles each step takes as long as two of
/// them.
constexpr double InnerReduction = 0.001;
/// Nor does a step go below this part of the residual of the step before: near other eigenvalues
/// steps gain little, however far they go.
constexpr double InnerPart = 0.1;
/// How far it goes where all steps are kept: as that space gains by each of them, many short steps
/// pay.
constexpr double InnerReductionInSpace = 0.2;
constexpr int MostInnerSteps = 8;
constexpr int MostInnerStepsInSpace = 6;
/// How far the last step goes, in parts of the tolerance: the residual of the pair is a little
/// larger than that of the equation.
constexpr double Margin = 0.9;
/// A step that does not reduce the residual by this factor is slow, unless it halves the value, as
/// where the smallest one is 0. FewSlowSteps of them in a row, or a matrix that is not positive
/// definite, show that other eigenvalues are near: from there on all steps are kept. So does a step
/// of MostInnerSteps that does not reach ReductionOfLongStep. The iteration has stalled where slow
/// steps in a row have taken MostSlowCycles V-cycles.
constexpr double SlowReduction = 0.7;
constexpr double ReductionOfLongStep = 0.2;
constexpr int FewSlowSteps = 2;
constexpr int MostSlowCycles = 100;
/// The iteration goes on to this residual though a larger one be allowed: mixtures of sections, and
/// others than the smallest, leave residuals above.
constexpr double TellingResidual = 1e-5;
/// The work of a step besides its cycles (see WorkLimit), by the row: with the space of all steps
/// that of its products, and of each of its sections.
constexpr double StepWork = 250.0;
constexpr double SpaceWork = 100.0;
constexpr double SpaceWorkOfSection = 15.0;
/// That of a hierarchy, by the entry of its matrices.
constexpr double HierarchyWork = 110.0;

ComplexVector Section(const SectionBlock& block, int b)
{
  ComplexVector section = Uninitialized(block.Rows());
  ParallelFor(block.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        section[v] = SectionValue(block.Vectors, v, b);
      }
    });
  return section;
}

/// The matrices of a basis: the sections b = 1, 2, 3 of a block of Ritz vectors, then some others.
struct Projected
{
  SmallMatrix Energy;
  SmallMatrix Mass;

  explicit Projected(Eigen::Index size = 0)
    : Energy(SmallMatrix::Zero(size, size))
    , Mass(SmallMatrix::Zero(size, size))
  {
  }
  Projected& operator+=(const Projected& other)
  {
    this->Energy += other.Energy;
    this->Mass += other.Mass;
    return *this;
  }
};

using Sections = std::vector<const SectionProducts*>;

/// V^* A V and V^* M V of the basis V.
/// @param values of the block's sections
Projected Project(
  const SectionBlock& block, const Eigen::VectorXd& values, const Sections& sections)
{
  const int count = static_cast<int>(sections.size());
  const Eigen::Index size = Width - 1 + count;
  Projected sum = ParallelSum<Projected>(block.Rows(), PieceRows, Projected(size),
    [&](Index begin, Index end)
    {
      Projected part(size);
      for (int column = 0; column < count; ++column)
      {
        const SectionProducts& section = *sections[column];
        // The block's own products are of no use: their rounding would exceed a vanishing
        // eigenvalue.
        WideSum energy;
        WideSum mass;
        for (Index v = begin; v < end; ++v)
        {
          const CompactValues<Width> other(block.Vectors.data(), v);
          energy.Add(other, section.Energy[v]);
          mass.Add(other, section.Mass[v]);
        }
        for (int b = 1; b < Width; ++b)
        {
          part.Energy(b - 1, Width - 1 + column) = energy.Value(b);
          part.Mass(b - 1, Width - 1 + column) = mass.Value(b);
        }
        const Index length = end - begin;
        for (int row = 0; row <= column; ++row)
        {
          const auto other = sections[row]->Vector.segment(begin, length);
          part.Energy(Width - 1 + row, Width - 1 + column) =
            other.dot(section.Energy.segment(begin, length));
          part.Mass(Width - 1 + row, Width - 1 + column) =
            other.dot(section.Mass.segment(begin, length));
        }
      }
      return part;
    });
  for (int b = 1; b < Width; ++b)
  {
    sum.Energy(b - 1, b - 1) = values[b];
    sum.Mass(b - 1, b - 1) = 1.0;
  }
  sum.Energy = SmallMatrix(sum.Energy.selfadjointView<Eigen::Upper>());
  sum.Mass = SmallMatrix(sum.Mass.selfadjointView<Eigen::Upper>());
  return sum;
}

/// The rows begin to end - 1 of the linear combination of the basis vectors.
ComplexVector LinearCombination(const SectionBlock& block, const Sections& sections,
  const Eigen::VectorXcd& coefficients, Index begin, Index end)
{
  ComplexVector sum(end - begin);
  for (Index v = begin; v < end; ++v)
  {
    Complex value = 0.0;
    for (int b = 1; b < Width; ++b)
    {
      value += coefficients[b - 1] * SectionValue(block.Vectors, v, b);
    }
    for (std::size_t k = 0; k < sections.size(); ++k)
    {
      value += coefficients[Width - 1 + k] * sections[k]->Vector[v];
    }
    sum[v - begin] = value;
  }
  return sum;
}

/// t = a t + b s in the rows begin to end - 1 of vectors and products.
void AddTo(SectionProducts& t, const Complex& a, const SectionProducts& s, const Complex& b,
  Index begin, Index end)
{
  for (const auto member :
    { &SectionProducts::Vector, &SectionProducts::Energy, &SectionProducts::Mass })
  {
    auto part = (t.*member).segment(begin, end - begin);
    part = a * part + b * (s.*member).segment(begin, end - begin);
  }
}

/// Replaces the first of four sections by u.
void SetFirst(const ComplexVector& u, CompactSections& sections)
{
  ParallelFor(static_cast<Index>(u.size()), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        SetSectionValue(sections, v, 0, u[v]);
      }
    });
}

/// Two sums over the rows: one that the energy products enter, and another one.
struct Figures
{
  double Energy = 0.0;
  double Other = 0.0;
  Figures& operator+=(const Figures& other)
  {
    this->Energy += other.Energy;
    this->Other += other.Other;
    return *this;
  }
};

/// The iteration on the finest level. Each step adds to the space of u and the last step the
/// solution t of the correction equation P^* (A - theta M) P t = r, r = theta M u - A u, and takes
/// the space's smallest Ritz vector for u.
class Iteration
{
public:
  /// @param nested the sections that the iteration begins with; its next pairs are deflated
  Iteration(const Operators& operators, const Hierarchy::Level& finest, const Cycle& cycle,
    const EigenpairSettings& settings, const Progress& progress, NestedPairs& nested)
    : Matrices(operators)
    , Settings(settings)
    , Cycles(progress)
    , Values(nested.Values)
    , Block(nested.Block)
    , Gradients(finest, cycle, nested.Block)
    , U(operators, Section(nested.Block, 0))
    , Terms(SumOfMagnitudes(operators.Energy, this->U.Vector) /
        std::sqrt(
          std::max(RealDot(this->U.Vector, this->U.Mass), std::numeric_limits<double>::min())))
  {
    this->Best.Residual = std::numeric_limits<double>::infinity();
    this->Cycles.Spend(nested.Work);
  }

  /// The best pair, which is also put in place of the first section that the iteration began with.
  Eigenpair Run()
  {
    do
    {
      this->Cycles.Report();
    } while (this->MeasureU() && !this->IsDone() && this->Step());
    this->KeepBest();
    if (this->Best.Vector.size() > 0)
    {
      SetFirst(this->Best.Vector, this->Block.Vectors);
      this->Values[0] = this->Best.Value;
    }
    this->Best.RequiredResidual = this->RequiredResidual();
    this->Best.Iterations = this->Cycles.GetCount();
    return std::move(this->Best);
  }

private:
  /// Scales u to unit length and finds its value and how large its residual is. False where they
  /// are not finite.
  bool MeasureU()
  {
    const Index rows = this->Block.Rows();
    SectionProducts& u = this->U;
    const Figures figures = ParallelSum<Figures>(rows, PieceRows, {},
      [&](Index begin, Index end)
      {
        Figures part;
        for (Index v = begin; v < end; ++v)
        {
          part.Energy += (std::conj(u.Vector[v]) * u.Energy[v]).real();
          part.Other += (std::conj(u.Vector[v]) * u.Mass[v]).real();
        }
        return part;
      });
    // A is positive semi-definite: values below zero are rounding.
    const double value = std::max(0.0, figures.Energy / figures.Other);
    const double perLength = 1.0 / std::sqrt(figures.Other);
    const Figures squares = ParallelSum<Figures>(rows, PieceRows, {},
      [&](Index begin, Index end)
      {
        for (ComplexVector* vector : { &u.Vector, &u.Energy, &u.Mass })
        {
          vector->segment(begin, end - begin) *= perLength;
        }
        const auto energy = u.Energy.segment(begin, end - begin);
        const auto mass = u.Mass.segment(begin, end - begin);
        return Figures{ energy.squaredNorm(), (value * mass - energy).squaredNorm() };
      });
    this->Value = value;
    this->ResidualNorm = std::sqrt(squares.Other);
    this->Relative = RelativeResidual(this->ResidualNorm, std::sqrt(squares.Energy), this->Terms);
    return std::isfinite(this->Relative);
  }

  /// Keeps u where it is the best so far, and counts slow steps. Whether the iteration has
  /// converged, stalled or used up its V-cycles.
  bool IsDone()
  {
    const double reduction = this->IsLong ? ReductionOfLongStep : SlowReduction;
    if (this->Relative < reduction * this->Best.Residual || this->Value < 0.5 * this->Best.Value)
    {
      this->Slow = 0;
      this->GoodCycles = this->Cycles.GetCount();
    }
    else
    {
      this->Slow += this->IsLong ? FewSlowSteps : 1;
    }
    if (this->Relative < this->Best.Residual)
    {
      this->Best.Value = this->Value;
      this->Best.Residual = this->Relative;
      this->Best.Vector = ComplexVector();
      this->IsBest = true;
    }
    return this->Best.Residual <= this->RequiredResidual() || this->CyclesLeft() <= 0 ||
      this->Cycles.GetCount() - this->GoodCycles >= MostSlowCycles || this->IsTooMuchWork();
  }

  /// Whether another solver is the better choice. How much work is still to come is judged by the
  /// second half of the work done.
  bool IsTooMuchWork()
  {
    if (!this->Settings.Limit)
    {
      return false;
    }
    const double work = this->Cycles.GetWork();
    this->History.push_back({ work, this->Best.Residual });
    const auto half = std::partition_point(this->History.begin() + 1, this->History.end(),
                        [&](const auto& before) { return before.Work <= 0.5 * work; }) -
      1;
    return !this->Settings.Limit->Allows(work,
      RemainingWork(
        work - half->Work, half->Residual, this->Best.Residual, this->RequiredResidual()));
  }

  double RequiredResidual() const { return std::min(this->Settings.Tolerance, TellingResidual); }

  int CyclesLeft() const { return this->Settings.MaximumIterations - this->Cycles.GetCount(); }

  /// Lays u aside, which is about to be replaced, if it is the best so far: copies would take more
  /// memory.
  void KeepBest()
  {
    if (this->IsBest)
    {
      this->Best.Vector = std::move(this->U.Vector);
      this->IsBest = false;
    }
  }

  /// False where the space of the step has no Ritz vector.
  bool Step()
  {
    SetFirst(this->U.Vector, this->Block.Vectors);
    const double reduction = std::max(this->Space
        ? InnerReductionInSpace
        : std::clamp(InnerPart * this->Relative / this->Before, InnerReduction, InnerPart),
      Margin * this->RequiredResidual() / this->Relative);
    this->Before = this->Relative;
    this->Cycles.Spend(this->Block.Rows() *
      (StepWork + (this->Space ? SpaceWork + SpaceWorkOfSection * this->Space->Size() : 0.0)));
    const int mostSteps = this->Space ? MostInnerStepsInSpace : MostInnerSteps;
    ComplexVector correction;
    const DeflatedGradients::Outcome outcome =
      this->Gradients.Solve({ this->U, this->Value, this->ResidualNorm }, -this->Value, reduction,
        std::min(this->CyclesLeft(), mostSteps), this->Cycles, correction);
    this->IsLong = !this->Space && outcome.Steps >= MostInnerSteps;
    if (!this->Space && (outcome.Indefinite || this->Slow >= FewSlowSteps))
    {
      this->BeginSpace();
    }
    if (!this->Space)
    {
      return this->StepWithLast(std::move(correction));
    }
    this->Space->Add(std::move(correction));
    if (this->Space->GetValues().size() == 0)
    {
      return false;
    }
    this->KeepBest();
    this->U = this->Space->First(this->Block);
    const int known = std::min(this->Space->Size(), Width);
    this->Values.head(known) = this->Space->GetValues().head(known);
    return true;
  }

  /// From here on all steps are kept.
  void BeginSpace()
  {
    this->Space.emplace(this->Matrices);
    this->Space->Add(Copied(this->U.Vector));
    for (int b = 1; b < Width; ++b)
    {
      this->Space->Add(Section(this->Block, b));
    }
    if (this->Last.Vector.size() > 0)
    {
      this->Space->Add(std::move(this->Last.Vector));
    }
  }

  /// Takes the smallest Ritz vector of the next pairs' sections, u, the correction and the last
  /// step.
  bool StepWithLast(ComplexVector correction)
  {
    SectionProducts t(this->Matrices, std::move(correction));
    Sections sections{ &this->U, &t };
    if (this->Last.Vector.size() > 0)
    {
      sections.push_back(&this->Last);
    }
    const Projected projected = Project(this->Block, this->Values, sections);
    const RitzPairs ritz = RayleighRitz(projected.Energy, projected.Mass, 1);
    if (ritz.Values.size() == 0)
    {
      return false;
    }
    const Eigen::VectorXcd c = ritz.Vectors.col(0);
    const bool isFirst = this->Last.Vector.size() == 0;
    // The next u takes the storage of the last step, since the iteration needs most memory here.
    Resize(this->Last.Vector, this->Block.Rows());
    ParallelFor(this->Block.Rows(), PieceRows,
      [&](Index begin, Index end)
      {
        const ComplexVector part = LinearCombination(this->Block, sections, c, begin, end);
        if (!isFirst)
        {
          AddTo(t, c[Width], this->Last, c[Width + 1], begin, end);
        }
        this->Last.Vector.segment(begin, end - begin) = part;
      });
    ComplexVector next = std::move(this->Last.Vector);
    this->Last = std::move(t);
    this->KeepBest();
    this->U.Set(this->Matrices, std::move(next));
    return true;
  }

  const Operators& Matrices;
  const EigenpairSettings& Settings;
  SolveCounter Cycles;
  /// Ritz values and vectors of the four smallest pairs; u in place of the first one.
  Eigen::VectorXd& Values;
  SectionBlock& Block;
  DeflatedGradients Gradients;
  SectionProducts U;
  /// ‖|A| |u|‖ for the first u, of unit length.
  double Terms;
  /// theta = u^* A u / u^* M u
  double Value = 0.0;
  /// ‖theta M u - A u‖, its relative size, and that before the last step.
  double ResidualNorm = 0.0;
  double Relative = 0.0;
  double Before = std::numeric_limits<double>::infinity();
  /// The last step; empty before the first one.
  SectionProducts Last;
  /// The number of slow steps in a row, and the V-cycles done before the first of them.
  int Slow = 0;
  /// The last step took as many V-cycles as a step may.
  bool IsLong = false;
  int GoodCycles = 0;
  /// The space of all steps, where u and the last one do not suffice.
  std::optional<RitzSpace> Space;
  /// The vector is not there yet while u is the best so far.
  Eigenpair Best;
  bool IsBest = false;
  /// The best residuals after so much work; empty where there is no limit.
  struct Mark
  {
    double Work;
    double Residual;
  };
  std::vector<Mark> History;
};
}

Eigenpair SolveByJacobiDavidson(const Operators& operators, const Hierarchy& hierarchy,
  const EigenpairSettings& settings, const Progress& progress, LowestSections& lowest)
{
  Eigenpair none;
  none.Residual = std::numeric_limits<double>::infinity();
  Cycle cycle(hierarchy, 0.0);
  if (!cycle.IsUsable())
  {
    return none;
  }
  NestedPairs nested = IterateNested(operators, hierarchy, cycle, progress);
  nested.Work += HierarchyWork * hierarchy.OperatorComplexity() *
    static_cast<double>(operators.Energy.nonZeros());
  if (nested.Values.size() < Width)
  {
    return none;
  }
  // Cycles for single sections need less storage.
  cycle.ReleaseStorage();
  Eigenpair best =
    Iteration(operators, hierarchy.GetLevels().front(), cycle, settings, progress, nested).Run();
  lowest = { std::move(nested.Block.Vectors), std::move(nested.Values) };
  return best;
}
}
