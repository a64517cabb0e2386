// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/PoissonSolver.h"

#include "Laplacian/LaplacianCycle.h"
#include "Matrices/VectorOperations.h"
#include "Systems/ConjugateGradientLoop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr int MostSteps = 400;

/// The vertices of a set are one row.
GraphLaplacian LaplacianOf(const DiscreteForms& forms, const ConstrainedSets& constrained)
{
  const TriangleMesh& mesh = forms.GetMesh();
  const TriangleMesh::Component& component = forms.GetComponent();
  GraphLaplacian laplacian(constrained.NumberOfUnknowns, component.Edges(),
    [&](Index e)
    {
      const Index h = mesh.HalfEdge(component.FirstEdge + e);
      return GraphLaplacian::Edge{ constrained.UnknownOf(forms.LocalTail(h)),
        constrained.UnknownOf(forms.LocalHead(h)), forms.Weight(e) };
    });
  if (!constrained.Unknown.empty())
  {
    laplacian.Merge();
  }
  return laplacian;
}

Eigen::VectorXd AreasOf(const DiscreteForms& forms, const ConstrainedSets& constrained)
{
  const Eigen::VectorXd ofVertices = forms.VertexAreas();
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(constrained.NumberOfUnknowns);
  for (Index v = 0; v < static_cast<Index>(ofVertices.size()); ++v)
  {
    areas[constrained.UnknownOf(v)] += ofVertices[v];
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

PoissonSolver::PoissonSolver(const DiscreteForms& forms, const ConstrainedSets& constrained)
  : Unknown(constrained.Unknown)
  , Areas(AreasOf(forms, constrained))
  , Area(this->Areas.sum())
  , Hierarchy(LaplacianOf(forms, constrained), this->Areas)
{
}

/// Conjugate gradients among the values that the sets leave open. Residuals are projected to them
/// before and after the V-cycle: the few conditions cost a few more steps, and the hierarchy stays
/// the same whatever they are. The cycle is in single precision, all else in double precision.
class PoissonSolver::Iteration
{
public:
  Iteration(const PoissonSolver& solver, const Problem& problem, Eigen::VectorXd& values)
    : Solver(solver)
    , Given(problem)
    , Values(values)
    , Cycles(solver.Hierarchy,
        problem.Diagonal ? std::max(0.0, problem.Diagonal->sum() / solver.Area) : 0.0)
    , Residual(problem.RightHandSide)
    , Direction(values.size())
    , Unit(values.size())
    , Corrected(values.size())
    , Image(values.size())
  {
    if (values.cwiseAbs().maxCoeff() > 0.0)
    {
      solver.GetLaplacian().Multiply(values, this->Image);
      this->Residual -= this->Image;
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
    ForRows(this->Residual,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          this->Unit[v] = static_cast<float>(this->Residual[v] / this->Left);
        }
      });
    this->Cycles.Apply(this->Unit, this->Corrected);
    Eigen::Map<Eigen::VectorXf> corrected(
      this->Corrected.data(), static_cast<Eigen::Index>(this->Corrected.size()));
    this->Project(corrected);
    return ParallelSum<double>(static_cast<Index>(this->Corrected.size()), VectorPiece, 0.0,
      [&](Index begin, Index end)
      {
        double sum = 0.0;
        for (Index v = begin; v < end; ++v)
        {
          sum += this->Residual[v] * static_cast<double>(this->Corrected[v]);
        }
        return this->Left * sum;
      });
  }

  void SetDirection(double keep)
  {
    ForRows(this->Direction,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          const double corrected = this->Left * static_cast<double>(this->Corrected[v]);
          this->Direction[v] = keep == 0.0 ? corrected : corrected + keep * this->Direction[v];
        }
      });
  }

  double FindCurvature()
  {
    double curvature = this->Solver.GetLaplacian().Multiply(this->Direction, this->Image);
    if (this->Given.Diagonal)
    {
      curvature += ParallelSum<double>(static_cast<Index>(this->Direction.size()), VectorPiece, 0.0,
        [&](Index begin, Index end)
        {
          double sum = 0.0;
          for (Index v = begin; v < end; ++v)
          {
            const double product = (*this->Given.Diagonal)[v] * this->Direction[v];
            this->Image[v] += product;
            sum += product * this->Direction[v];
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
          this->Values[v] += step * this->Direction[v];
          this->Residual[v] -= step * this->Image[v];
        }
      });
    this->Project(this->Residual);
    this->Left = std::sqrt(Dot(this->Residual, this->Residual));
    ++this->Steps;
  }

private:
  /// To the residuals and steps that change nothing that is given.
  template <typename Vector>
  void Project(Vector&& x) const
  {
    if (this->Given.Merged)
    {
      this->Given.Merged->Average(x);
    }
    if (this->Given.Held)
    {
      for (const Index unknown : *this->Given.Held)
      {
        x[unknown] = 0;
      }
    }
  }

  const PoissonSolver& Solver;
  const Problem& Given;
  Eigen::VectorXd& Values;
  LaplacianCycle Cycles;
  Eigen::VectorXd Residual;
  Eigen::VectorXd Direction;
  /// The residual over its length, and the result of a V-cycle on it.
  LargeArray<float> Unit;
  LargeArray<float> Corrected;
  /// The product of matrix and direction.
  Eigen::VectorXd Image;
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
