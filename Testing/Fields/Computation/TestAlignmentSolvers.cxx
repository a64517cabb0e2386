// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/ComponentStage.h"
#include "Computation/Stages.h"
#include "DirectionField.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

using namespace DirectionFields;
using namespace Meshes;

TEST(AlignmentSolvers, AnyStrengthGivesAFieldThoughTheEigenvalueIsNotKnownWell)
{
  // lambda_t may not come above the true lambda_1, which is less than the computed one.
  for (const Solver solver : { Solver::Direct, Solver::Multigrid })
  {
    for (const double tolerance : { 1e-6, 1e-2, 5e-2 })
    {
      for (const double strength : { 0.0, 1e-7, 1e-4, 1e-2 })
      {
        Options options;
        options.Solver = solver;
        options.Tolerance = tolerance;
        options.MaximumIterations = tolerance > 1e-6 ? 5 : 200;
        options.Alignment = Alignment::PrincipalCurvature;
        options.AlignmentStrength = strength;
        const Result result = DirectionField(Potato(4)).Compute(options);
        const ComponentReport& report = result.Components[0];
        EXPECT_LE(report.SystemResidual, tolerance) << strength;
        EXPECT_LE(report.Lambda, report.Eigenvalue);
        EXPECT_GE(report.SmoothnessEnergy, (1.0 - tolerance) * report.Eigenvalue);
        EXPECT_EQ(report.IndexSum, 8);
      }
    }
  }
}

TEST(AlignmentSolvers, NoSolverGivesAFieldOfZeros)
{
  // The energy of a flat square vanishes for many fields if s = 1.
  Options options;
  options.EnergyBias = 1.0;
  options.AlignmentStrength = 1e-7;
  options.Alignment = Alignment::PointVectors;
  const Surface surface = Square(60);
  Guidance guidance;
  for (const Vector3& p : surface.Points)
  {
    guidance.Vectors.emplace_back(1.0, p[0] * p[1], 0.0);
  }
  for (const Solver solver : { Solver::Multigrid, Solver::Direct })
  {
    options.Solver = solver;
    const Result result = DirectionField(surface).Compute(options, guidance);
    double squares = 0.0;
    for (const Complex& u : result.Representation)
    {
      squares += std::norm(u);
    }
    EXPECT_GT(squares, 0.1 * static_cast<double>(surface.Points.size()));
    EXPECT_GE(result.Components[0].SmoothnessEnergy, 0.0);
  }
}

TEST(AlignmentSolvers, ConstraintsThatAreZeroLeaveTheSmoothestField)
{
  const System system(Potato(5), 4, 0.0);
  EigenpairSettings settings;
  settings.Scale = system.Scale;
  for (const Solver solver : { Solver::Direct, Solver::Multigrid })
  {
    SmallestPairs pairs = FindSmallestPairs(system.Matrices,
      [&] { return RandomVector(system.Matrices.Energy.rows(), 2); }, solver, settings, {});
    const Eigenpair smoothest = pairs.First;
    ComponentStage stage(system.Matrices, std::move(pairs), system.Scale, 1.0);
    for (const ConstraintSolver how : { ConstraintSolver::Energy, ConstraintSolver::LeastSquares })
    {
      Options options;
      options.Solver = solver;
      options.ConstraintSolver = how;
      ComponentReport report;
      const ComplexVector u =
        stage.Solve({ {}, { { 0, 7 }, ComplexVector::Zero(2) }, 1.0 }, options, {}, report);
      // Least squares need a factor.
      EXPECT_EQ(report.SolverUsed, how == ConstraintSolver::Energy ? solver : Solver::Direct);
      EXPECT_NEAR(report.SmoothnessEnergy, smoothest.Value, 1e-9 * smoothest.Value);
      const Complex overlap = smoothest.Vector.dot(system.Matrices.Mass * u);
      EXPECT_NEAR(
        std::abs(overlap), std::sqrt(system.Lengths.ComponentArea[0]), 1e-9 * std::abs(overlap));
    }
  }
}

TEST(AlignmentSolvers, AStoppedSolutionLeavesTheStageAsItWas)
{
  // A small system is factored on the caller's thread and asks once for that, so that the second
  // question is one of the solution; of a large one the factorization asks several times.
  for (const int levels : { 3, 5 })
  {
    const System system(Potato(levels), 4, 0.0);
    EigenpairSettings settings;
    settings.Scale = system.Scale;
    const ComponentGuide guide{ RandomVector(system.Matrices.Energy.rows(), 1), {}, 1.0 };
    for (const Solver solver : { Solver::Direct, Solver::Multigrid })
    {
      Options options;
      options.Solver = solver;
      const auto makeStage = [&]
      {
        return ComponentStage(system.Matrices,
          FindSmallestPairs(system.Matrices,
            [&] { return RandomVector(system.Matrices.Energy.rows(), 2); }, solver, settings, {}),
          system.Scale, 1.0);
      };
      ComponentStage stage = makeStage();
      int questions = 0;
      const ProgressFunction stop = [&](double) { return ++questions < 2; };
      ComponentReport report;
      EXPECT_THROW(stage.Solve(guide, options, Progress(stop), report), Stopped);
      EXPECT_EQ(questions, 2);
      const ComplexVector u = stage.Solve(guide, options, {}, report);
      EXPECT_LE(report.SystemResidual, options.Tolerance);
      ComponentReport other;
      EXPECT_EQ(u, makeStage().Solve(guide, options, {}, other));
    }
  }
}

/// As an eigenpair that has not converged may have it, whatever its residual.
TEST(AlignmentSolvers, WhereLambda1WasOverestimatedLambdaTIsLess)
{
  const System system(Potato(4), 4, 0.0);
  EigenpairSettings settings;
  settings.Scale = system.Scale;
  const ComponentGuide guide{ RandomVector(system.Matrices.Energy.rows(), 1), {}, 1.0 };
  for (const Solver solver : { Solver::Direct, Solver::Multigrid })
  {
    double exact = 0.0;
    for (const double part : { 0.1, 1e-4 })
    {
      SmallestPairs pairs = FindSmallestPairs(system.Matrices,
        [&] { return RandomVector(system.Matrices.Energy.rows(), 2); }, solver, settings, {});
      exact = pairs.First.Value;
      pairs.First.Value = 3.0 * exact;
      pairs.First.Residual = 1e-3;
      ComponentStage stage(system.Matrices, std::move(pairs), system.Scale, 1.0);
      Options options;
      options.UseShift = true;
      options.Shift = part * exact;
      ComponentReport report;
      stage.Solve(guide, options, {}, report);
      EXPECT_LT(report.Lambda, exact);
      EXPECT_LE(report.SystemResidual, options.Tolerance);
      EXPECT_GT(report.SmoothnessEnergy, 0.999 * exact);
      // The solver of the system that was solved in the end, not of those before.
      EXPECT_EQ(report.SolverUsed, solver);
    }
  }
}

TEST(AlignmentSolvers, WhatNoGapMakesDefiniteIsAnError)
{
  System system(Potato(3), 4, 0.0);
  system.Matrices.Energy = SparseMatrix(-system.Matrices.Energy);
  const ComponentGuide guide{ RandomVector(system.Matrices.Energy.rows(), 1),
    { { 0 }, ComplexVector::Ones(1) }, 1.0 };
  Options options;
  options.UseShift = true;
  options.ConstraintSolver = ConstraintSolver::Energy;
  for (const double value : { 0.0, 1e-17, 1.0 })
  {
    for (const double shift : { 0.0, 1e-300, 1e-3 })
    {
      SmallestPairs pairs;
      pairs.First.Value = value;
      ComponentStage stage(system.Matrices, std::move(pairs), system.Scale, 1.0);
      options.Shift = shift;
      ComponentReport report;
      EXPECT_THROW(stage.Solve(guide, options, {}, report), NotPositiveDefinite)
        << value << ", " << shift;
    }
  }
}

TEST(AlignmentSolvers, GuidanceAndConstraintsMayChangeBetweenCalls)
{
  const Surface surface = Hemisphere(3);
  Guidance one;
  Guidance other;
  for (const Vector3& point : surface.Points)
  {
    one.Vectors.push_back(Vector3(0.3, 1.0, point.x()).cross(point));
    other.Vectors.push_back(one.Vectors.size() == 9 ? Vector3(1.0, 2.0, 3.0) : one.Vectors.back());
  }
  Options options;
  options.Solver = Solver::Direct;
  options.AlignmentStrength = 0.4;
  DirectionField kept(surface);
  std::vector<Complex> before;
  const auto expectOfAFreshOne = [&](const Guidance& guidance)
  {
    const std::vector<Complex> now = kept.Compute(options, guidance).Representation;
    EXPECT_EQ(now, DirectionField(surface).Compute(options, guidance).Representation);
    EXPECT_NE(now, before);
    before = now;
  };
  options.Alignment = Alignment::PointVectors;
  expectOfAFreshOne(one);
  options.AlignmentStrength = 0.6;
  expectOfAFreshOne(one);
  expectOfAFreshOne(other);
  options.ConstrainBoundary = true;
  expectOfAFreshOne(other);
  expectOfAFreshOne(one);
  options.ConstrainBoundary = false;
  expectOfAFreshOne(one);
  options.Alignment = Alignment::None;
  expectOfAFreshOne({});
  options.Alignment = Alignment::PrincipalCurvature;
  expectOfAFreshOne({});
}
