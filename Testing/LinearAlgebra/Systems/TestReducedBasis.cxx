// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Eigenpairs/JacobiDavidson.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Systems/ConjugateGradients.h"
#include "Systems/ReducedBasis.h"

#include <gtest/gtest.h>

#include <utility>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
double Distance(const std::vector<Complex>& a, const std::vector<Complex>& b)
{
  const Eigen::Map<const ComplexVector> x(a.data(), static_cast<Eigen::Index>(a.size()));
  const Eigen::Map<const ComplexVector> y(b.data(), static_cast<Eigen::Index>(b.size()));
  return (x - y).norm() / y.norm();
}
}

TEST(ReducedBasis, IsClosestInTheNormOfTheMatrix)
{
  const System system(Potato(3), 4, 0.0);
  const Eigen::Index n = system.Matrices.Energy.rows();
  const ComplexVector b = RandomVector(n, 1);
  ReducedBasis basis;
  EXPECT_EQ(basis.Closest(1.0, 2.0, b).Vector.norm(), 0.0);
  EXPECT_EQ(basis.Closest(1.0, 2.0, b).Vector.size(), n);
  std::vector<ComplexVector> vectors;
  for (unsigned seed = 2; seed < 6; ++seed)
  {
    vectors.push_back(RandomVector(n, seed));
    basis.Add({ system.Matrices, vectors.back() }, 1.0, 0.0, b, 0.0);
  }
  // What is left is orthogonal to the basis.
  for (const double m : { 0.0, 0.3, 1e6 })
  {
    const SparseMatrix k = 2.0 * system.Matrices.Energy + m * system.Matrices.Mass;
    const ComplexVector rest = b - k * basis.Closest(2.0, m, b).Vector;
    for (const ComplexVector& v : vectors)
    {
      EXPECT_LT(std::abs(v.dot(rest)), 1e-10 * v.norm() * b.norm());
    }
  }
  // A vector of the span is found, and a dependent one does not disturb.
  const ComplexVector wanted = vectors[0] - Complex(0.0, 2.0) * vectors[3];
  basis.Add({ system.Matrices, vectors[1] + 1e-9 * vectors[2] }, 1.0, 0.0, b, 0.0);
  const SparseMatrix k = system.Matrices.Energy + system.Matrices.Mass;
  EXPECT_LT((basis.Closest(1.0, 1.0, k * wanted).Vector - wanted).norm(), 1e-6 * wanted.norm());
}

TEST(ReducedBasis, ForgetsTheOldest)
{
  const System system(Potato(2), 4, 0.0);
  const Eigen::Index n = system.Matrices.Energy.rows();
  const SparseMatrix k = system.Matrices.Energy + system.Matrices.Mass;
  ReducedBasis basis;
  const auto distance = [&](unsigned seed)
  {
    const ComplexVector v = RandomVector(n, seed);
    return (basis.Closest(1.0, 1.0, k * v).Vector - v).norm() / v.norm();
  };
  for (unsigned seed = 0; seed <= ReducedBasis::MostVectors; ++seed)
  {
    basis.Add({ system.Matrices, RandomVector(n, seed) }, 1.0, 0.0, RandomVector(n, 100), 0.0);
  }
  EXPECT_GT(distance(0), 0.1);
  for (unsigned seed = 1; seed <= ReducedBasis::MostVectors; ++seed)
  {
    EXPECT_LT(distance(seed), 1e-10) << seed;
  }
}

TEST(ReducedBasis, SavesStepsOfTheNextStrengths)
{
  const System system(Potato(5), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  EigenpairSettings settings;
  settings.Scale = system.Scale;
  LowestSections lowest;
  const double smallest =
    SolveByJacobiDavidson(system.Matrices, hierarchy, settings, {}, lowest).Value;
  const ComplexVector b = system.Matrices.Mass * RandomVector(system.Matrices.Energy.rows(), 1);
  std::vector<int> stepsOfMoves[2];
  for (const bool othersFollow : { false, true })
  {
    ReducedBasis solved;
    std::vector<int>& steps = stepsOfMoves[othersFollow];
    for (int move = 0; move < 6; ++move)
    {
      steps.push_back(0);
      const ProgressFunction count = [&](double) { return ++steps.back() > 0; };
      const double shift = system.Scale * (0.5 + 0.1 * move) - smallest;
      const ShiftedSystem shifted{ system.Matrices, 1.0, shift, 1e-6, Progress(count),
        othersFollow };
      const SystemSolution solution = ConjugateGradients(shifted, hierarchy, lowest, b, solved);
      const SparseMatrix k = system.Matrices.Energy + shift * system.Matrices.Mass;
      EXPECT_LE((k * solution.Vector - b).norm(), 1.01e-6 * b.norm());
      EXPECT_NEAR(solution.Residual, (k * solution.Vector - b).norm() / b.norm(), 1e-10);
    }
    EXPECT_GE(steps[0], 8);
    EXPECT_LE(2 * steps[5], steps[0]);
    EXPECT_LT(steps[1], steps[0]);
  }
  // Derivatives take steps once, and save some of the next solution.
  EXPECT_GT(stepsOfMoves[true][0], stepsOfMoves[false][0]);
  EXPECT_LE(stepsOfMoves[true][0], 2 * stepsOfMoves[false][0]);
  EXPECT_LE(stepsOfMoves[true][1], stepsOfMoves[false][1] - 2);
}

/// The field itself does not depend on whether others follow.
TEST(ReducedBasis, OneStrengthAloneNeedsNoDerivatives)
{
  Options options;
  options.Solver = Solver::Multigrid;
  options.Alignment = Alignment::PrincipalCurvature;
  const auto steps = [&](bool othersFollow, std::vector<Complex>& field)
  {
    int calls = 0;
    const ProgressFunction count = [&](double) { return ++calls > 0; };
    DirectionField solver(Potato(5));
    field = (othersFollow ? solver.Compute(options, {}, count)
                          : std::move(solver).Compute(options, {}, count))
              .Representation;
    return calls;
  };
  std::vector<Complex> alone;
  std::vector<Complex> first;
  EXPECT_LE(steps(false, alone) + 4, steps(true, first));
  EXPECT_EQ(alone, first);
}

TEST(ReducedBasis, TheSameOptionsGiveTheSameBytesAlsoWhereRoundingIsReached)
{
  // The residual is measured by more than the right-hand side there.
  Options options;
  options.Solver = Solver::Multigrid;
  options.Alignment = Alignment::PrincipalCurvature;
  options.AlignmentStrength = 1e-7;
  DirectionField field(Potato(6));
  const Result once = field.Compute(options);
  EXPECT_TRUE(once.Components[0].Converged);
  EXPECT_EQ(field.Compute(options).Representation, once.Representation);
}

TEST(ReducedBasis, FieldsDoNotDependOnTheOnesBefore)
{
  // Beyond the tolerance.
  for (const bool constrains : { false, true })
  {
    const Surface surface = Hemisphere(5);
    Options options;
    options.Solver = Solver::Multigrid;
    options.Alignment = Alignment::PrincipalCurvature;
    options.ConstrainBoundary = constrains;
    options.ConstraintSolver = ConstraintSolver::Energy;
    DirectionField kept(surface);
    for (const double strength : { 0.5, 0.55, 0.9, 0.02, 0.5, 1.0 })
    {
      options.AlignmentStrength = strength;
      const Result result = kept.Compute(options);
      const Result fresh = DirectionField(surface).Compute(options);
      EXPECT_LE(result.Components[0].SystemResidual, 1e-6);
      EXPECT_LT(Distance(result.Representation, fresh.Representation), 2e-5) << strength;
      EXPECT_EQ(result.Components[0].IndexSum, fresh.Components[0].IndexSum) << strength;
      EXPECT_EQ(kept.Compute(options).Representation, result.Representation);
    }
    // The same options give the same bytes.
    options.AlignmentStrength = 0.9;
    const std::vector<Complex> once = kept.Compute(options).Representation;
    options.AlignmentStrength = 0.3;
    EXPECT_GT(Distance(kept.Compute(options).Representation, once), 1e-3);
    options.AlignmentStrength = 0.9;
    EXPECT_EQ(kept.Compute(options).Representation, once);
  }
}
