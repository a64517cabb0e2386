// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Solvers/Systems/DirectSystem.h"
#include "Solvers/Systems/LeastSquares.h"

#include <gtest/gtest.h>

#include <utility>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// Random unit values.
GivenValues OnBoundary(const System& system)
{
  GivenValues given;
  for (Index v = 0; v < static_cast<Index>(system.Matrices.Energy.rows()); ++v)
  {
    if (system.Mesh.IsBoundary(v))
    {
      given.Vertices.push_back(v);
    }
  }
  given.Values = RandomVector(static_cast<Eigen::Index>(given.Vertices.size()), 3);
  return given;
}
}

TEST(LeastSquares, AreThoseOfTheDirectSolverInFewSteps)
{
  for (const auto& [levels, most] : { std::pair(4, 16), std::pair(5, 24) })
  {
    const System system(Hemisphere(levels), 4, 0.0);
    const auto n = static_cast<Index>(system.Matrices.Energy.rows());
    const GivenValues given = OnBoundary(system);
    const ComplexVector b = system.Scale * (system.Matrices.Mass * RandomVector(n, 4));
    const FreeSystem freeSystem(system.Matrices, given.Vertices, system.Scale);
    int steps = 0;
    const ProgressFunction count = [&](double) { return ++steps > 0; };
    const ShiftedSystem shifted{ system.Matrices, 1.0, 0.5 * system.Scale, 4e-9, Progress(count) };
    const SystemSolution fast = MinimizeResidualByMultigrid(shifted, freeSystem, b, given);
    const SparseMatrix k = system.Matrices.Energy + 0.5 * system.Scale * system.Matrices.Mass;
    const SystemSolution direct = MinimizeResidualDirectly(k, b, given);
    EXPECT_LE(fast.Residual, 5e-9);
    EXPECT_LT((fast.Vector - direct.Vector).norm(), 1e-6 * direct.Vector.norm());
    EXPECT_EQ(ComplexVector(fast.Vector(given.Vertices)), given.Values);
    EXPECT_LE(steps, most);
  }
}

TEST(LeastSquares, StopWhenTold)
{
  const System system(Hemisphere(4), 4, 0.0);
  GivenValues given{ { 0, 700 }, ComplexVector::Ones(2) };
  const FreeSystem freeSystem(system.Matrices, given.Vertices, system.Scale);
  int calls = 0;
  const ProgressFunction goOn = [&](double) { return ++calls < 4; };
  const ShiftedSystem shifted{ system.Matrices, 1.0, 0.0, 1e-8, Progress(goOn) };
  EXPECT_THROW(MinimizeResidualByMultigrid(
                 shifted, freeSystem, ComplexVector::Zero(system.Matrices.Energy.rows()), given),
    Stopped);
  EXPECT_EQ(calls, 4);
}

/// Triangles that are all very thin take more steps the more of them there are.
TEST(LeastSquares, GoOnWhileTheyGetCloser)
{
  const Eigen::Vector3d squeezed(0.002, 1.0, 1.0);
  const System system(
    Transformed(FlatlySubdivided(Hemisphere(1), 5), squeezed.asDiagonal(), Vector3::Zero()), 1,
    0.0);
  const auto n = static_cast<Index>(system.Matrices.Energy.rows());
  const GivenValues given = OnBoundary(system);
  const FreeSystem freeSystem(system.Matrices, given.Vertices, system.Scale);
  int steps = 0;
  const ProgressFunction count = [&](double) { return ++steps > 0; };
  const ShiftedSystem shifted{ system.Matrices, 1.0, 0.0, 1e-8, Progress(count) };
  const SystemSolution solution =
    MinimizeResidualByMultigrid(shifted, freeSystem, ComplexVector::Zero(n), given);
  EXPECT_GT(steps, 300);
  EXPECT_LE(steps, 400);
  EXPECT_LE(solution.Residual, 1e-8);
  // The gradient by Eigen's own products.
  const auto gradient = [&](const ComplexVector& u)
  {
    const ComplexVector all = system.Matrices.Energy * (system.Matrices.Energy * u);
    return ComplexVector(all(freeSystem.Free.GetVertices())).norm();
  };
  ComplexVector start = ComplexVector::Zero(n);
  start(given.Vertices) = given.Values;
  EXPECT_LE(gradient(solution.Vector), 1e-8 * gradient(start));
}
