// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/Lanczos.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include <cmath>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Eigen::VectorXd SystemEigenvalues(const Operators& o)
{
  return DenseEigenpairs(Eigen::MatrixXcd(o.Energy), Eigen::MatrixXcd(o.Mass)).Values;
}

/// So many quads in a row, of length 1.
Surface Strip(Index quads, double width)
{
  Surface strip;
  for (Index i = 0; i <= quads; ++i)
  {
    strip.Points.emplace_back(i, 0.0, 0.0);
    strip.Points.emplace_back(i, width, 0.0);
  }
  for (Index a = 0; a < 2 * quads; a += 2)
  {
    strip.Triangles.push_back({ a, a + 2, a + 3 });
    strip.Triangles.push_back({ a, a + 3, a + 1 });
  }
  return strip;
}

bool PositiveDefinite(const SparseMatrix& m)
{
  const Eigen::SimplicialLDLT<SparseMatrix> solver(m);
  return solver.info() == Eigen::Success && solver.vectorD().real().minCoeff() > 0.0;
}
}

TEST(Lanczos, EqualsTheDenseSolver)
{
  for (const Surface& surface :
    { Potato(2), Hemisphere(2), Jittered(Torus(12, 9), 0.05, 2), DoubleTorus() })
  {
    for (const double bias : { -0.9, 0.0, 0.9 })
    {
      const System system(surface, 4, bias);
      EigenpairSettings settings;
      settings.Tolerance = 1e-9;
      settings.Scale = system.Scale;
      const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
        RandomVector(system.Matrices.Energy.rows(), 1), settings);
      const double exact = SystemEigenvalues(system.Matrices)[0];
      EXPECT_LE(pair.Residual, 1e-9);
      EXPECT_NEAR(pair.Value / exact, 1.0, 1e-9);
      EXPECT_NEAR(pair.Vector.dot(system.Matrices.Mass * pair.Vector).real(), 1.0, 1e-12);
      const ComplexVector residual =
        system.Matrices.Energy * pair.Vector - pair.Value * (system.Matrices.Mass * pair.Vector);
      EXPECT_LE(residual.norm(), 1.1e-9 * (system.Matrices.Energy * pair.Vector).norm());
    }
  }
}

/// On a long strip many eigenvalues are next to nothing, and any mixture of their sections leaves a residual
/// that a loose tolerance lets pass.
TEST(Lanczos, FindsTheSmallestPairOfAStripAtLooseTolerances)
{
  const Surface strip = Strip(3000, 1.0);
  for (const int degree : { 2, 4, 6 })
  {
    for (const double bias : { -0.9, 0.0, 0.9 })
    {
      // The transported direction is parallel: the smallest eigenvalue is 0.
      const System system(strip, degree, bias);
      for (const double tolerance : { 1e-6, 1e-4, 1e-3, 1e-2, 0.1 })
      {
        EigenpairSettings settings;
        settings.Scale = system.Scale;
        settings.Tolerance = tolerance;
        const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
          RandomVector(system.Matrices.Energy.rows(), 2), settings);
        EXPECT_LE(pair.Residual, tolerance);
        EXPECT_LE(pair.Value, 1e-4 * std::min(tolerance, 1e-3) * system.Scale)
          << degree << ", " << bias << ", " << tolerance;
      }
    }
  }
}

/// The energies of bias 1 and -1 have hundreds of eigenvalues next to nothing there.
TEST(Lanczos, LeavesNoEigenvalueBelowWhatTheTolerancePromises)
{
  for (const double width : { 0.1, 1.0 })
  {
    for (const int degree : { 1, 4, 6 })
    {
      for (const double bias : { -1.0, 1.0 })
      {
        const System system(Strip(3000, width), degree, bias);
        for (const double tolerance : { 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1 })
        {
          EigenpairSettings settings;
          settings.Scale = system.Scale;
          settings.Tolerance = tolerance;
          const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
            RandomVector(system.Matrices.Energy.rows(), 2), settings);
          EXPECT_TRUE(HasConverged(pair)) << degree << ", " << bias << ", " << tolerance;
          // Rounding hides the second term.
          const double below = pair.Value - 1.5 * tolerance * (pair.Value + 1e-5 * system.Scale) -
            1.5e-14 *
              (system.Matrices.Energy.diagonal().real().array() * pair.Vector.array().abs2()).sum();
          EXPECT_TRUE(
            below <= 0.0 || PositiveDefinite(system.Matrices.Energy - below * system.Matrices.Mass))
            << width << ", " << degree << ", " << bias << ", " << tolerance;
        }
      }
    }
  }
}

/// At a loose tolerance the second pair has passed for the smallest one, if the start is hardly anything else.
TEST(Lanczos, FindsTheSmallestPairOfAPoorStart)
{
  const System system(Potato(3), 4, 0.0);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  const DensePairs dense = DenseEigenpairs(Eigen::MatrixXcd(a), Eigen::MatrixXcd(m));
  const Eigen::VectorXd& values = dense.Values;
  for (const double tolerance : { 1e-4, 1e-3, 1e-2 })
  {
    EXPECT_GT(values[1], (1.0 + 2.0 * tolerance) * values[0]) << "the promise tells them apart";
    EigenpairSettings settings;
    settings.Tolerance = tolerance;
    settings.Scale = system.Scale;
    const ComplexVector start = dense.Vectors.col(1) + 1e-9 * dense.Vectors.col(0);
    const Eigenpair pair = SolveByLanczos(a, m, start, settings);
    EXPECT_TRUE(HasConverged(pair));
    EXPECT_LE(pair.Value, (1.0 + tolerance) * values[0] + tolerance * settings.NextToNothing());
    // One solve does not find the smallest pair, and the second one does not pass for it.
    settings.MaximumIterations = 1;
    const Eigenpair second = SolveByLanczos(a, m, start, settings);
    EXPECT_FALSE(HasConverged(second));
    EXPECT_GT(second.Value, (1.0 + tolerance) * values[0]);
    EXPECT_LE(second.Residual, tolerance);
  }
}

TEST(Lanczos, NoEigenvalueLiesBelow)
{
  // By Sylvester's law of inertia: A - x M is definite just below the value found, not above it.
  for (const int degree : { 1, 4, 6 })
  {
    const System system(Potato(4), degree, 0.0);
    EigenpairSettings settings;
    settings.Scale = system.Scale;
    const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
      RandomVector(system.Matrices.Energy.rows(), 7), settings);
    EXPECT_LE(pair.Residual, settings.Tolerance);
    EXPECT_TRUE(PositiveDefinite(
      system.Matrices.Energy - (pair.Value * (1.0 - 1e-6)) * system.Matrices.Mass));
    EXPECT_FALSE(PositiveDefinite(
      system.Matrices.Energy - (pair.Value * (1.0 + 1e-6)) * system.Matrices.Mass));
  }
}

TEST(Lanczos, StartNearlyOrthogonalToTheSolution)
{
  const System system(Potato(3), 4, 0.0);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  EigenpairSettings settings;
  settings.Tolerance = 1e-10;
  settings.Scale = system.Scale;
  const Eigenpair pair = SolveByLanczos(a, m, RandomVector(a.rows(), 3), settings);
  ComplexVector start = RandomVector(a.rows(), 4);
  start -= pair.Vector * pair.Vector.dot(m * start);
  start += 1e-6 * pair.Vector;
  const Eigenpair other = SolveByLanczos(a, m, start, settings);
  EXPECT_NEAR(other.Value / pair.Value, 1.0, 1e-9);
  EXPECT_LE(other.Residual, 1e-10);
}

TEST(Lanczos, DegenerateEigenspaceGivesTheProjectionOfTheStart)
{
  // The tetrahedral symmetry leaves no single direction; both solvers must agree on the rest.
  const System system(Icosphere(1), 1, 0.0);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  const ComplexVector start = RandomVector(a.rows(), 9);
  const DensePairs dense = DenseEigenpairs(Eigen::MatrixXcd(a), Eigen::MatrixXcd(m));
  const Eigen::Index multiplicity = (dense.Values.array() < dense.Values[0] * (1.0 + 1e-9)).count();
  EXPECT_EQ(multiplicity, 3);
  const auto space = dense.Vectors.leftCols(multiplicity);
  ComplexVector projection = space * (space.adjoint() * (m * start));
  projection /= std::sqrt(projection.dot(m * projection).real());
  ASSERT_LE(a.rows(), 48) << "the dense branch is meant";
  const Eigenpair small = SolveByLanczos(a, m, start, {});
  EXPECT_NEAR(std::abs(projection.dot(m * small.Vector)), 1.0, 1e-9);
  EXPECT_EQ(small.Iterations, 0);

  const System fine(Icosphere(3), 1, 0.0);
  EigenpairSettings settings;
  settings.Scale = fine.Scale;
  settings.Tolerance = 1e-9;
  const Eigenpair large = SolveByLanczos(fine.Matrices.Energy, fine.Matrices.Mass,
    RandomVector(fine.Matrices.Energy.rows(), 9), settings);
  EXPECT_LE(large.Residual, 1e-9);
}

TEST(Lanczos, SaysWhenItHasNotConverged)
{
  const System system(Potato(4), 4, 0.0);
  EigenpairSettings settings;
  settings.Tolerance = 1e-12;
  settings.MaximumIterations = 4;
  settings.Scale = system.Scale;
  const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
    RandomVector(system.Matrices.Energy.rows(), 5), settings);
  EXPECT_EQ(pair.Iterations, 4);
  EXPECT_GT(pair.Residual, 1e-12);
  EXPECT_TRUE(pair.Vector.allFinite());
  EXPECT_NEAR(pair.Residual,
    RelativeResidual(
      system.Matrices.Energy, SectionProducts(system.Matrices, pair.Vector), pair.Value),
    1e-15);
}

TEST(Lanczos, RestartsKeepConverging)
{
  // The holomorphic energy has 2n + 1 small eigenvalues that lie close together.
  const System system(Jittered(Icosphere(3), 0.01, 1), 6, 1.0);
  EigenpairSettings settings;
  settings.Tolerance = 1e-10;
  settings.Scale = system.Scale;
  settings.MaximumIterations = 1000;
  const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
    RandomVector(system.Matrices.Energy.rows(), 5), settings);
  EXPECT_LE(pair.Residual, 1e-10);
  EXPECT_TRUE(
    PositiveDefinite(system.Matrices.Energy - (pair.Value * (1.0 - 1e-6)) * system.Matrices.Mass));
}

TEST(Lanczos, StopsWhenTold)
{
  const System system(Potato(3), 4, 0.0);
  int calls = 0;
  const ProgressFunction stop = [&](double) { return ++calls < 3; };
  EXPECT_THROW(SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
                 RandomVector(system.Matrices.Energy.rows(), 5), {}, Progress(stop)),
    Stopped);
  EXPECT_EQ(calls, 3);
}
