// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

TEST(Multigrid, BytesDoNotDependOnTheThreads)
{
  // The second has constraints, which enter by least squares.
  for (const Surface& surface : { Potato(5), Hemisphere(5) })
  {
    Options options;
    options.Solver = Solver::Multigrid;
    options.ConstrainBoundary = true;
    std::vector<Complex> serial;
    for (const int threads : { 1, 2, 3 })
    {
      options.NumberOfThreads = threads;
      const Result result = DirectionField(surface).Compute(options);
      EXPECT_EQ(result.Components[0].SolverUsed, Solver::Multigrid);
      EXPECT_GT(result.Components[0].Iterations, 0);
      EXPECT_LE(result.Components[0].SystemResidual, 1e-6);
      serial = serial.empty() ? result.Representation : serial;
      EXPECT_EQ(result.Representation, serial) << threads;
    }
  }
}

TEST(Multigrid, AutomaticFallsBackToTheDirectSolver)
{
  Options options;
  // Enough for the direct solver, not for multigrid, since many smallest eigenvalues lie together.
  options.Degree = 6;
  options.EnergyBias = 0.9;
  options.MaximumIterations = 20;
  options.Solver = Solver::Multigrid;
  const Surface surface = Potato(5);
  const ComponentReport multigrid = DirectionField(surface).Compute(options).Components[0];
  EXPECT_EQ(multigrid.SolverUsed, Solver::Multigrid);
  EXPECT_FALSE(multigrid.Converged);
  EXPECT_LE(multigrid.Iterations, 20);
  options.Solver = Solver::Automatic;
  const ComponentReport automatic = DirectionField(surface).Compute(options).Components[0];
  EXPECT_EQ(automatic.SolverUsed, Solver::Direct);
  EXPECT_TRUE(automatic.Converged);
}

/// A residual of the tolerance does not tell the smallest one of 17 close eigenvalues from the others.
TEST(Multigrid, ALooseToleranceIsNotEnoughWhereEigenvaluesAreClose)
{
  Options options;
  options.Degree = 8;
  options.Tolerance = 0.1;
  options.Solver = Solver::Multigrid;
  const Surface sphere = Icosphere(4);
  const ComponentReport all = DirectionField(sphere).Compute(options).Components[0];
  EXPECT_TRUE(all.Converged);
  EXPECT_LE(all.RequiredResidual, 1e-5);
  EXPECT_LE(all.Residual, all.RequiredResidual);
  options.MaximumIterations = all.Iterations / 2;
  const ComponentReport half = DirectionField(sphere).Compute(options).Components[0];
  EXPECT_LE(half.Residual, options.Tolerance);
  EXPECT_FALSE(half.Converged);
}

TEST(Multigrid, SmallComponentsAreSolvedDirectlyByAutomatic)
{
  Options options;
  options.NumberOfThreads = 2;
  const Result result = DirectionField(Joined(Potato(2), Potato(5))).Compute(options);
  EXPECT_EQ(result.Components[0].SolverUsed, Solver::Direct);
  EXPECT_EQ(result.Components[1].SolverUsed, Solver::Multigrid);
  options.Solver = Solver::Direct;
  EXPECT_EQ(DirectionField(Potato(5)).Compute(options).Components[0].SolverUsed, Solver::Direct);
}

TEST(SmoothestField, SaysWhereItHasFaded)
{
  Options options;
  EXPECT_TRUE(DirectionField(Potato(4)).Compute(options).Notes.empty());
  const Surface rough = Roughened(Icosphere(4), 1.0, 1);
  const Result faded = DirectionField(rough).Compute(options);
  double longest = 0.0;
  for (const Complex& u : faded.Representation)
  {
    longest = std::max(longest, std::abs(u));
  }
  const auto count = std::count_if(faded.Representation.begin(), faded.Representation.end(),
    [&](const Complex& u) { return std::abs(u) < 1e-5 * longest; });
  const double percent = 100.0 * static_cast<double>(count) / faded.Representation.size();
  ASSERT_GT(percent, 50.5);
  ASSERT_EQ(faded.Notes.size(), 1u);
  EXPECT_EQ(
    faded.Notes[0].rfind(
      "The field has faded at " + std::to_string(std::lround(percent)) + " % of the points", 0),
    0u);
  EXPECT_NE(faded.Notes[0].find("Unit Length"), std::string::npos);
  options.UnitLength = true;
  EXPECT_TRUE(DirectionField(rough).Compute(options).Notes.empty());
}
