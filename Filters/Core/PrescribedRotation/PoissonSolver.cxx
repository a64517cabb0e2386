// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedRotation/PoissonSolver.h"

#include "Sections/Assembly.h"
#include "Solvers/Matrices/SparseProducts.h"
#include "Solvers/Matrices/VectorOperations.h"
#include "Solvers/Systems/ConjugateGradientLoop.h"
#include "Solvers/Systems/CyclePreconditioner.h"

#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr int MostSteps = 400;

/// The operators among the unknowns: rows and columns of the vertices of a group are added up.
Operators Joined(Operators&& operators, const GivenGroups& groups)
{
  if (groups.Unknown.empty())
  {
    return std::move(operators);
  }
  std::vector<Eigen::Triplet<Complex, Index>> ones;
  for (std::size_t v = 0; v < groups.Unknown.size(); ++v)
  {
    ones.emplace_back(static_cast<Index>(v), groups.Unknown[v], 1.0);
  }
  SparseMatrix toUnknowns(static_cast<Index>(groups.Unknown.size()), groups.NumberOfUnknowns);
  toUnknowns.setFromTriplets(ones.begin(), ones.end());
  const SparseMatrix fromVertices = toUnknowns.adjoint();
  Operators joined;
  joined.Energy = SparseProduct(fromVertices, SparseProduct(operators.Energy, toUnknowns));
  joined.Mass = SparseProduct(fromVertices, SparseProduct(operators.Mass, toUnknowns));
  return joined;
}

/// A third of the area at each row: each triangle has a sixth of its area at three places of the diagonal.
Eigen::VectorXd AreasOf(const Operators& operators, const GivenGroups& groups)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(groups.NumberOfUnknowns);
  const Eigen::VectorXcd diagonal = operators.Mass.diagonal();
  for (Index v = 0; v < static_cast<Index>(diagonal.size()); ++v)
  {
    areas[groups.UnknownOf(v)] += 2.0 * diagonal[v].real();
  }
  return areas;
}

double Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  return ParallelSum<double>(static_cast<Index>(a.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    { return a.segment(begin, end - begin).dot(b.segment(begin, end - begin)); });
}
}

PoissonSolver::PoissonSolver(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, const GivenGroups& groups)
  : PoissonSolver(AssembleOperators(geometry, component, 0, 0.0), groups)
{
}

PoissonSolver::PoissonSolver(Operators&& operators, const GivenGroups& groups)
  : Unknown(groups.Unknown)
  , Areas(AreasOf(operators, groups))
  , Area(this->Areas.sum())
  , Laplacian((operators = Joined(std::move(operators), groups)), 1.0, 0.0)
  , Hierarchy(operators, 2.0 * Pi / this->Area, LeftOver::Drop)
{
}

/// Conjugate gradients among the values that the sets leave open. Residuals are projected to them before and after
/// the V-cycle: the few conditions cost a few more steps, and the hierarchy stays the same whatever they are. Directions are
/// kept in single precision, with the products of what they are then; values and residuals in double precision.
class PoissonSolver::Iteration
{
public:
  Iteration(const PoissonSolver& solver, const Problem& problem, Eigen::VectorXd& values)
    : Solver(solver)
    , Given(problem)
    , Values(values)
    , Cycles(solver.Hierarchy,
        problem.Diagonal ? std::max(0.0, problem.Diagonal->sum() / solver.Area) : 0.0, Lowest)
    , Residual(problem.RightHandSide)
    , Corrected(values.size())
    , Direction(static_cast<std::size_t>(values.size()))
    , Compact(static_cast<std::size_t>(values.size()))
  {
    if (values.cwiseAbs().maxCoeff() > 0.0)
    {
      const ComplexVector start = values.cast<Complex>();
      Resize(this->Image, values.size());
      solver.Laplacian.Multiply(start, this->Image);
      this->Residual -= this->Image.real();
      if (problem.Diagonal)
      {
        this->Residual -= problem.Diagonal->cwiseProduct(values);
      }
    }
    this->Project(this->Residual);
    const double start = std::sqrt(Dot(this->Residual, this->Residual));
    this->Size = std::max(start, std::sqrt(Dot(problem.RightHandSide, problem.RightHandSide)));
    this->Left = start;
  }

  bool IsUsable() const { return this->Cycles.IsUsable(); }
  double GetRelativeResidual() const { return this->Size > 0.0 ? this->Left / this->Size : 0.0; }

  bool GoesOn()
  {
    this->Given.Progress.RequireToGoOn();
    return this->Left > this->Given.Tolerance * this->Size && this->Steps < MostSteps;
  }

  double Precondition()
  {
    const double unit = this->Left;
    ForRows(this->Residual,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          this->Compact[v] = CompactComplex(static_cast<float>(this->Residual[v] / unit), 0.0F);
        }
      });
    const CyclePreconditioner::Result result = this->Cycles.Apply(this->Compact);
    const double product =
      ParallelSum<double>(static_cast<Index>(this->Corrected.size()), VectorPiece, 0.0,
        [&](Index begin, Index end)
        {
          double sum = 0.0;
          for (Index v = begin; v < end; ++v)
          {
            const double z = unit * result(v).real();
            this->Corrected[v] = z;
            sum += this->Residual[v] * z;
          }
          return sum;
        });
    // The residual is projected already, hence its product with the projected vector is the same.
    this->Project(this->Corrected);
    return product;
  }

  void SetDirection(double keep)
  {
    ForRows(this->Corrected,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          const double next = keep == 0.0
            ? this->Corrected[v]
            : this->Corrected[v] + keep * static_cast<double>(this->Direction[v].real());
          this->Direction[v] = CompactComplex(static_cast<float>(next), 0.0F);
        }
      });
  }

  double FindCurvature()
  {
    Resize(this->Image, this->Corrected.size());
    double curvature = this->Solver.Laplacian.Multiply(this->Direction, this->Image);
    if (this->Given.Diagonal)
    {
      curvature += ParallelSum<double>(static_cast<Index>(this->Corrected.size()), VectorPiece, 0.0,
        [&](Index begin, Index end)
        {
          double sum = 0.0;
          for (Index v = begin; v < end; ++v)
          {
            const double x = this->Direction[v].real();
            const double product = (*this->Given.Diagonal)[v] * x;
            this->Image[v] += product;
            sum += product * x;
          }
          return sum;
        });
    }
    return curvature;
  }

  void Advance(double step)
  {
    ForRows(this->Residual,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          this->Values[v] += step * static_cast<double>(this->Direction[v].real());
          this->Residual[v] -= step * this->Image[v].real();
        }
      });
    this->Project(this->Residual);
    this->Left = std::sqrt(Dot(this->Residual, this->Residual));
    ++this->Steps;
  }

private:
  /// To the residuals and steps that change nothing that is given.
  void Project(Eigen::VectorXd& x) const
  {
    if (this->Given.Rigid)
    {
      this->Given.Rigid->Average(x);
    }
    if (this->Given.Held)
    {
      for (const Index unknown : *this->Given.Held)
      {
        x[unknown] = 0.0;
      }
    }
  }

  const PoissonSolver& Solver;
  const Problem& Given;
  Eigen::VectorXd& Values;
  static inline const LowestSections Lowest = {};
  CyclePreconditioner Cycles;
  Eigen::VectorXd Residual;
  /// What a V-cycle makes of the residual.
  Eigen::VectorXd Corrected;
  CompactVector Direction;
  CompactVector Compact;
  /// The product of matrix and direction.
  ComplexVector Image;
  double Size;
  double Left;
  int Steps = 0;
};

double PoissonSolver::Solve(const Problem& problem, Eigen::VectorXd& values) const
{
  Iteration iteration(*this, problem, values);
  if (iteration.IsUsable())
  {
    TakeConjugateGradientSteps(iteration);
  }
  return iteration.GetRelativeResidual();
}

Eigen::VectorXd PoissonSolver::Gathered(const Eigen::VectorXd& vertices) const
{
  if (this->Unknown.empty())
  {
    return vertices;
  }
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(this->NumberOfUnknowns());
  for (std::size_t v = 0; v < this->Unknown.size(); ++v)
  {
    sums[this->Unknown[v]] += vertices[static_cast<Index>(v)];
  }
  return sums;
}

Eigen::VectorXd PoissonSolver::Spread(const Eigen::VectorXd& unknowns) const
{
  if (this->Unknown.empty())
  {
    return unknowns;
  }
  Eigen::VectorXd values(static_cast<Eigen::Index>(this->Unknown.size()));
  for (std::size_t v = 0; v < this->Unknown.size(); ++v)
  {
    values[static_cast<Index>(v)] = unknowns[this->Unknown[v]];
  }
  return values;
}
}
