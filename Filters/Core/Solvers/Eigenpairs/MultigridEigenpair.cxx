// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Eigenpairs/MultigridEigenpair.h"

#include "Solvers/Eigenpairs/DeflatedGradients.h"
#include "Solvers/Eigenpairs/NestedIteration.h"
#include "Solvers/Eigenpairs/RitzSpace.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Matrices/VectorOperations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr int Width = SectionBlock::Width;
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// How far one Jacobi-Davidson step solves its correction equation: further is of no use with the
/// eigenvalue that is in it. Each step takes as long as two V-cycles besides.
constexpr double InnerReduction = 0.001;
/// Nor below this part of what the step before has left: near other eigenvalues steps gain little,
/// however far they go.
constexpr double InnerPart = 0.1;
/// In a space that grows with each step more steps pay.
constexpr double InnerReductionInSpace = 0.2;
constexpr int MostInnerSteps = 40;
/// How far the last step goes, in parts of the tolerance: the residual of the pair is a little larger
/// than that of the equation.
constexpr double Margin = 0.9;
/// A step that does not reduce the residual by this factor is slow. Few in a row, or a matrix that is
/// not positive definite, show that other eigenvalues are near; the iteration stalls where so many
/// V-cycles have gone into slow ones, more than in those few.
constexpr double SlowReduction = 0.7;
constexpr int FewSlowSteps = 2;
constexpr int MostSlowCycles = 100;

Complex Entry(const CompactSections& block, Index v, int b)
{
  const float* x = block.data() + static_cast<std::size_t>(2 * Width) * v;
  return { x[b], x[Width + b] };
}

ComplexVector Section(const SectionBlock& block, int b)
{
  ComplexVector section = Uninitialized(block.Rows());
  ParallelFor(block.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        section[v] = Entry(block.Vectors, v, b);
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
        // Not with the block's own products, whose rounding would exceed a vanishing eigenvalue.
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

/// The combination of the basis.
ComplexVector Combined(
  const SectionBlock& block, const Sections& sections, const Eigen::VectorXcd& coefficients)
{
  ComplexVector sum = Uninitialized(block.Rows());
  ParallelFor(block.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        Complex value = 0.0;
        for (int b = 1; b < Width; ++b)
        {
          value += coefficients[b - 1] * Entry(block.Vectors, v, b);
        }
        for (std::size_t k = 0; k < sections.size(); ++k)
        {
          value += coefficients[Width - 1 + k] * sections[k]->Vector[v];
        }
        sum[v] = value;
      }
    });
  return sum;
}

/// t = a t + b s, and so the products.
void AddTo(SectionProducts& t, const Complex& a, const SectionProducts& s, const Complex& b)
{
  ParallelFor(static_cast<Index>(t.Vector.size()), PieceRows,
    [&](Index begin, Index end)
    {
      for (const auto member :
        { &SectionProducts::Vector, &SectionProducts::Energy, &SectionProducts::Mass })
      {
        auto part = (t.*member).segment(begin, end - begin);
        part = a * part + b * (s.*member).segment(begin, end - begin);
      }
    });
}

/// Sums over the rows: of what has to do with A u, and of what with M u or the residual.
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

/// Puts u in place of the first of four sections.
void SetFirst(const ComplexVector& u, CompactSections& sections)
{
  ParallelFor(static_cast<Index>(u.size()), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const std::size_t at = static_cast<std::size_t>(2 * Width) * v;
        sections[at] = static_cast<float>(u[v].real());
        sections[at + Width] = static_cast<float>(u[v].imag());
      }
    });
}
}

Eigenpair SmallestEigenpair(const Operators& operators, const Hierarchy& hierarchy,
  const EigenpairSettings& settings, const std::function<bool(int)>& progress,
  LowestSections& lowest)
{
  Eigenpair best;
  best.Residual = std::numeric_limits<double>::infinity();
  const auto goOn = [&]
  {
    best.Aborted = best.Aborted || (progress && !progress(best.Iterations));
    return !best.Aborted;
  };
  Cycle cycle(hierarchy, 0.0);
  if (!cycle.IsUsable())
  {
    return best;
  }
  NestedPairs nested = IterateNested(operators, hierarchy, cycle, goOn);
  if (best.Aborted || nested.Values.size() < Width)
  {
    return best;
  }

  // Single sections need less.
  cycle.ReleaseStorage();
  SectionBlock& others = nested.Block;
  const Index rows = others.Rows();
  SectionProducts u(operators, Section(others, 0));
  DeflatedGradients gradients(hierarchy.GetLevels().front(), cycle, others);
  const double terms = SumOfMagnitudes(operators.Energy, u.Vector) /
    std::sqrt(std::max(RealDot(u.Vector, u.Mass), std::numeric_limits<double>::min()));
  ComplexVector residual = Uninitialized(rows);
  /// The last step.
  SectionProducts search;
  /// The relative residual before it.
  double before = std::numeric_limits<double>::infinity();
  /// Steps in a row.
  int slow = 0;
  /// V-cycles before the first of them.
  int goodIterations = 0;
  /// Where one step and the last one do not suffice: all of them.
  std::optional<RitzSpace> space;
  while (goOn())
  {
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
    // A is positive semi-definite: what is less than zero is rounding.
    const double value = std::max(0.0, figures.Energy / figures.Other);
    const double perLength = 1.0 / std::sqrt(figures.Other);
    const Figures squares = ParallelSum<Figures>(rows, PieceRows, {},
      [&](Index begin, Index end)
      {
        for (ComplexVector* vector : { &u.Vector, &u.Energy, &u.Mass })
        {
          vector->segment(begin, end - begin) *= perLength;
        }
        auto rest = residual.segment(begin, end - begin);
        const auto energy = u.Energy.segment(begin, end - begin);
        rest = value * u.Mass.segment(begin, end - begin) - energy;
        return Figures{ energy.squaredNorm(), rest.squaredNorm() };
      });
    const double relative =
      RelativeResidual(std::sqrt(squares.Other), std::sqrt(squares.Energy), terms);
    if (!std::isfinite(relative))
    {
      break;
    }
    if (relative < SlowReduction * best.Residual)
    {
      slow = 0;
      goodIterations = best.Iterations;
    }
    else
    {
      ++slow;
    }
    if (relative < best.Residual)
    {
      best.Value = value;
      Copy(u.Vector, best.Vector);
      best.Residual = relative;
    }
    const int left = settings.MaximumIterations - best.Iterations;
    if (best.Residual <= settings.Tolerance || left <= 0 ||
      best.Iterations - goodIterations >= MostSlowCycles)
    {
      break;
    }
    SetFirst(u.Vector, others.Vectors);
    const double reduction =
      std::max(space ? InnerReductionInSpace
                     : std::clamp(InnerPart * relative / before, InnerReduction, InnerPart),
        Margin * settings.Tolerance / relative);
    before = relative;
    ComplexVector correction;
    const DeflatedGradients::Outcome outcome = gradients.Solve(residual, -value, reduction,
      std::min(left, MostInnerSteps),
      [&]
      {
        const bool on = goOn();
        ++best.Iterations;
        return on;
      },
      correction);
    if (outcome.Stopped)
    {
      break;
    }
    if (!space && (outcome.Indefinite || slow >= FewSlowSteps))
    {
      space.emplace(operators);
      space->Add(std::move(u.Vector));
      for (int b = 1; b < Width; ++b)
      {
        space->Add(Section(others, b));
      }
      if (search.Vector.size() > 0)
      {
        space->Add(std::move(search.Vector));
      }
    }
    if (space)
    {
      space->Add(std::move(correction));
      u = space->First();
      space->WriteNext(others);
      const int known = std::min(space->Size(), Width);
      nested.Values.head(known) = space->GetValues().head(known);
      continue;
    }
    SectionProducts t(operators, std::move(correction));
    Sections sections{ &u, &t };
    if (search.Vector.size() > 0)
    {
      sections.push_back(&search);
    }
    const Projected projected = Project(others, nested.Values, sections);
    const RitzPairs ritz = RayleighRitz(projected.Energy, projected.Mass, 1);
    if (ritz.Values.size() == 0)
    {
      break;
    }
    const Eigen::VectorXcd c = ritz.Vectors.col(0);
    u.Set(operators, Combined(others, sections, c));
    if (search.Vector.size() > 0)
    {
      AddTo(t, c[Width], search, c[Width + 1]);
    }
    search = std::move(t);
  }
  if (best.Vector.size() > 0)
  {
    SetFirst(best.Vector, others.Vectors);
    nested.Values[0] = best.Value;
  }
  lowest = { std::move(others.Vectors), std::move(nested.Values) };
  return best;
}
}
