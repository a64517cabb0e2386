// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/RotationAlignment.h"

#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Steps = 5;
constexpr int MostHalvings = 10;
constexpr double Tolerance = 1e-6;
/// tau beyond this would divide by zero.
constexpr double MostStrength = 1.0 - 1e-9;

/// The field after some steps with a strength.
/// @param weight strength times area times |q| at each vertex
TurnedField Aligned(TrivialConnection& rotation, const MergedUnknowns& merged,
  const ComplexVector& guidance, const Eigen::VectorXd& weight, const Progress& progress,
  const TurnedField& start)
{
  const PoissonSolver& solver = rotation.GetSolver();
  const std::vector<Index>& held = rotation.GetConstrained().GivenUnknowns;
  const Eigen::VectorXd diagonal = solver.Gathered(weight);
  TurnedField field = start;
  for (int step = 0; step < Steps; ++step)
  {
    const ComplexVector section = rotation.SectionOf(field);
    // The turn is one back, against the direction in which phases grow.
    Eigen::VectorXd wanted(section.size());
    for (Eigen::Index v = 0; v < section.size(); ++v)
    {
      wanted[v] = -weight[v] * std::arg(guidance[v] * std::conj(section[v]));
    }
    const Eigen::VectorXd right =
      solver.Gathered(rotation.GetForms().Inflow(field.Rotation) + wanted);
    PoissonSolver::Problem problem{ right };
    problem.Merged = &merged;
    problem.Diagonal = &diagonal;
    problem.Held = &held;
    problem.Tolerance = Tolerance;
    problem.Progress = progress;
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(solver.NumberOfUnknowns());
    field.Residual = solver.Solve(problem, turn);
    const Eigen::VectorXd spread = solver.Spread(turn);
    field.Turn += spread;
    rotation.GetForms().SubtractRise(spread, field.Rotation);
  }
  return field;
}
}

double StrengthOf(double alignmentStrength, int degree, double area)
{
  const double tau = std::min(alignmentStrength, MostStrength);
  return 2.0 * Pi * degree / area * tau / (1.0 - tau);
}

double AlignField(TrivialConnection& rotation, const RotationTarget& target,
  const ComplexVector& guidance, double strength, const Progress& progress, TurnedField& field)
{
  const PoissonSolver& solver = rotation.GetSolver();
  const Eigen::VectorXd areas = rotation.GetForms().VertexAreas();
  const double mean = std::sqrt((areas.array() * guidance.array().abs2()).sum() / solver.GetArea());
  if (!(mean > 0.0) || !std::isfinite(mean))
  {
    return 0.0;
  }
  const Eigen::VectorXd weight = areas.array() * guidance.array().abs() / mean;
  const MergedUnknowns merged =
    rotation.MergeSingular(target, field.Rotation, field.Settings, {}, nullptr);
  const std::size_t wrong = rotation.WrongTriangles(target, field).size();
  double share = 1.0;
  for (int halving = 0; halving <= MostHalvings; ++halving, share *= 0.5)
  {
    progress.Report(static_cast<double>(halving) / (MostHalvings + 1));
    TurnedField aligned =
      Aligned(rotation, merged, guidance, strength * share * weight, progress, field);
    if (rotation.WrongTriangles(target, aligned).size() <= wrong)
    {
      aligned.Energy = rotation.GetForms().Product(aligned.Rotation, aligned.Rotation);
      field = std::move(aligned);
      return share;
    }
  }
  return 0.0;
}
}
