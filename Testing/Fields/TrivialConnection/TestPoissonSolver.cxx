// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/PoissonSolver.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Components::Tested;

namespace
{
/// L x of the unknowns, by the forms.
Eigen::VectorXd Laplacian(
  const Tested& tested, const PoissonSolver& solver, const Eigen::VectorXd& x)
{
  return solver.Gathered(tested.Forms.Inflow(Components::Rise(tested.Forms, solver.Spread(x))));
}
}

TEST(PoissonSolver, FindsTheValuesThatARightHandSideWasMadeOf)
{
  for (const Surface& surface : { Meshes::Potato(4), Meshes::Torus(60, 30), Meshes::Disk(24) })
  {
    const Tested tested(surface);
    const PoissonSolver solver(tested.Forms, tested.Constrained);
    ASSERT_EQ(solver.NumberOfUnknowns(), tested.Component.Vertices());
    Eigen::VectorXd wanted = Components::RandomNumbers(solver.NumberOfUnknowns(), 4);
    wanted.array() -= wanted.mean();
    const Eigen::VectorXd right = Laplacian(tested, solver, wanted);
    PoissonSolver::Problem problem{ right };
    problem.Tolerance = 1e-10;
    Eigen::VectorXd found = Eigen::VectorXd::Zero(right.size());
    const double residual = solver.Solve(problem, found);
    EXPECT_LE(residual, problem.Tolerance);
    // The solver's weights are rounded to single precision.
    EXPECT_LT((Laplacian(tested, solver, found) - right).norm(), 1e-7 * right.norm());
    found.array() -= found.mean();
    EXPECT_LT((found - wanted).norm(), 1e-6 * wanted.norm());
  }
}

/// On the unit sphere -Laplace z = 2 z; the error falls with the square of the edge length.
TEST(PoissonSolver, ConvergesToTheSphericalHarmonic)
{
  double last = 0.0;
  for (const int levels : { 2, 3, 4 })
  {
    const Tested tested(Meshes::Icosphere(levels));
    const PoissonSolver solver(tested.Forms, tested.Constrained);
    const double unit = tested.Geometry.Lengths.Unit[0];
    Eigen::VectorXd z(solver.NumberOfUnknowns());
    for (Index v = 0; v < z.size(); ++v)
    {
      z[v] = tested.Geometry.Positions[v].z();
    }
    const Eigen::VectorXd right = 2.0 * unit * unit * solver.GetAreas().cwiseProduct(z);
    Eigen::VectorXd found = Eigen::VectorXd::Zero(z.size());
    solver.Solve(PoissonSolver::Problem{ right }, found);
    found.array() -= found.mean();
    const double error = std::sqrt(unit * unit * solver.GetAreas().dot((found - z).cwiseAbs2()));
    EXPECT_LT(error, last == 0.0 ? 0.1 : 0.3 * last);
    last = error;
  }
  EXPECT_LT(last, 0.01);
}

TEST(PoissonSolver, AddsTheDiagonalAndHoldsUnknowns)
{
  const Tested tested(Meshes::Potato(3));
  const PoissonSolver solver(tested.Forms, tested.Constrained);
  const Eigen::VectorXd diagonal = 0.1 * solver.GetAreas();
  const Eigen::VectorXd right = Components::RandomNumbers(solver.NumberOfUnknowns(), 5);
  const std::vector<Index> held = { 3, 50, 200 };
  Eigen::VectorXd found = Components::RandomNumbers(solver.NumberOfUnknowns(), 6);
  const Eigen::VectorXd guess = found;
  PoissonSolver::Problem problem{ right };
  problem.Diagonal = &diagonal;
  problem.Held = &held;
  problem.Tolerance = 1e-10;
  EXPECT_LE(solver.Solve(problem, found), problem.Tolerance);
  Eigen::VectorXd residual =
    Laplacian(tested, solver, found) + diagonal.cwiseProduct(found) - right;
  for (const Index v : held)
  {
    EXPECT_EQ(found[v], guess[v]);
    residual[v] = 0.0;
  }
  EXPECT_LT(residual.norm(), 1e-7 * right.norm());
}

TEST(PoissonSolver, JoinedUnknownsKeepTheirDifferences)
{
  const Tested tested(Meshes::Potato(3));
  const PoissonSolver solver(tested.Forms, tested.Constrained);
  MergedUnknowns merged(solver.NumberOfUnknowns());
  merged.Join(10, 400, 1.5);
  merged.Join(400, 77, -0.5);
  merged.Close();
  Eigen::VectorXd right = Components::RandomNumbers(solver.NumberOfUnknowns(), 7);
  right.array() -= right.mean();
  Eigen::VectorXd found = Eigen::VectorXd::Zero(right.size());
  merged.Satisfy(found);
  PoissonSolver::Problem problem{ right };
  problem.Merged = &merged;
  problem.Tolerance = 1e-9;
  EXPECT_LE(solver.Solve(problem, found), problem.Tolerance);
  EXPECT_NEAR(found[400] - found[10], 1.5, 1e-6);
  EXPECT_NEAR(found[77] - found[400], -0.5, 1e-6);
  // Of the joined ones only the sum of the residuals is open to the unknowns.
  Eigen::VectorXd residual = Laplacian(tested, solver, found) - right;
  EXPECT_NEAR(residual[10] + residual[400] + residual[77], 0.0, 1e-6 * right.norm());
  EXPECT_GT(std::abs(residual[10]), 1e-3);
  residual[10] = residual[400] = residual[77] = 0.0;
  EXPECT_LT(residual.norm(), 1e-6 * right.norm());
}

/// Connected given vertices are one unknown.
TEST(PoissonSolver, GathersAndSpreadsMergedVertices)
{
  const Surface square = Meshes::Square(6);
  const Tested tested(square, { 0, 1, 2 });
  const PoissonSolver solver(tested.Forms, tested.Constrained);
  EXPECT_EQ(solver.NumberOfUnknowns(), tested.Component.Vertices() - 2);
  EXPECT_NEAR(solver.GetAreas().sum(), solver.GetArea(), 1e-12 * solver.GetArea());
  const Eigen::VectorXd x = Components::RandomNumbers(solver.NumberOfUnknowns(), 8);
  const Eigen::VectorXd y = Components::RandomNumbers(tested.Component.Vertices(), 9);
  EXPECT_NEAR(solver.Spread(x).dot(y), solver.Gathered(y).dot(x), 1e-12);
}
