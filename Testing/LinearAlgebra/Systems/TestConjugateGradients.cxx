// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/JacobiDavidson.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Systems/ConjugateGradients.h"
#include "Systems/DirectSystem.h"
#include "Systems/FreeSystem.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
EigenpairSettings Settings(const System& system)
{
  EigenpairSettings settings;
  settings.Scale = system.Scale;
  return settings;
}
}

TEST(ConjugateGradients, StepsOfAlignedSystemsDoNotDependOnTheStrength)
{
  const System system(Potato(6), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  LowestSections lowest;
  const double smallest =
    SolveByJacobiDavidson(system.Matrices, hierarchy, Settings(system), {}, lowest).Value;
  const ComplexVector b = system.Matrices.Mass * RandomVector(system.Matrices.Energy.rows(), 1);
  for (const auto& [shift, most] : { std::pair(-0.99999, 16), std::pair(-0.99, 15),
         std::pair(-0.5, 13), std::pair(0.0, 13), std::pair(1.0, 13), std::pair(100.0, 11) })
  {
    ReducedBasis solved;
    int steps = 0;
    const ProgressFunction count = [&](double) { return ++steps > 0; };
    const ShiftedSystem shifted{ system.Matrices, 1.0, shift * smallest, 1e-6, Progress(count) };
    const SystemSolution solution = ConjugateGradients(shifted, hierarchy, lowest, b, solved);
    const ComplexVector rest = shifted.Times(solution.Vector) - b;
    EXPECT_LE(rest.norm(), 1e-6 * b.norm()) << shift;
    EXPECT_LE(steps, most) << shift;
  }
}

/// Though residuals are kept in single precision, which after the first step has no more than five
/// digits of the right-hand side left.
TEST(ConjugateGradients, TwiceTheDigitsTakeTwiceTheSteps)
{
  const System system(Potato(6), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const ComplexVector b = system.Matrices.Mass * RandomVector(system.Matrices.Energy.rows(), 1);
  const auto steps = [&](double tolerance)
  {
    ReducedBasis solved;
    int asked = 0;
    const ProgressFunction count = [&](double) { return ++asked > 0; };
    const ShiftedSystem shifted{ system.Matrices, 1.0, system.Scale, tolerance, Progress(count) };
    const SystemSolution solution = ConjugateGradients(shifted, hierarchy, {}, b, solved);
    const double rest = (shifted.Times(solution.Vector) - b).norm();
    EXPECT_LE(rest, tolerance * b.norm());
    EXPECT_NEAR(solution.Residual * b.norm(), rest, 0.01 * rest);
    return asked;
  };
  const int few = steps(1e-6);
  EXPECT_LE(few, 14);
  EXPECT_LE(steps(1e-12), 2 * few + 2);
}

TEST(ConjugateGradients, StopWhenTold)
{
  const System system(Potato(5), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const ComplexVector b = system.Matrices.Mass * RandomVector(system.Matrices.Energy.rows(), 1);
  int asked = 0;
  const ProgressFunction goOn = [&](double) { return ++asked < 4; };
  const ShiftedSystem shifted{ system.Matrices, 1.0, system.Scale, 1e-6, Progress(goOn) };
  ReducedBasis solved;
  EXPECT_THROW(ConjugateGradients(shifted, hierarchy, {}, b, solved), Stopped);
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(solved.Size(), 0);
}

/// Values given here and there leave patches that have little to do with each other, many of a few
/// vertices.
TEST(ConjugateGradients, HierarchiesOfPatchesBetweenGivenValuesGetSmall)
{
  const System system(Potato(6), 4, 0.0);
  const auto n = static_cast<Index>(system.Matrices.Energy.rows());
  std::mt19937 engine(1);
  GivenValues given;
  for (Index v = 0; v < n; ++v)
  {
    if (engine() % 2 == 0)
    {
      given.Vertices.push_back(v);
    }
  }
  given.Values = RandomVector(static_cast<Eigen::Index>(given.Vertices.size()), 2);
  FreeSystem freeSystem(system.Matrices, given.Vertices, system.Scale);
  EXPECT_LE(freeSystem.Hierarchy.GetLevels().back().Rows(), Hierarchy::CoarsestRows);
  EXPECT_LE(freeSystem.Hierarchy.OperatorComplexity(), 1.6);
  int steps = 0;
  const ProgressFunction count = [&](double) { return ++steps > 0; };
  const ShiftedSystem shifted{ system.Matrices, 1.0, 0.0, 1e-10, Progress(count) };
  const ComplexVector b = ComplexVector::Zero(n);
  const SystemSolution fast = MinimizeEnergyByMultigrid(shifted, freeSystem, b, given);
  const SystemSolution direct = MinimizeEnergyDirectly(system.Matrices.Energy, b, given);
  EXPECT_LT((fast.Vector - direct.Vector).norm(), 1e-9 * direct.Vector.norm());
  EXPECT_LE(steps, 13);
}
