// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Solvers/Eigenpairs/DeflatedGradients.h"
#include "Solvers/Eigenpairs/JacobiDavidson.h"
#include "Solvers/Eigenpairs/Lanczos.h"
#include "Solvers/Eigenpairs/NestedIteration.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Multigrid/LevelMatrices.h"
#include "Solvers/Multigrid/SmoothedAggregation.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
ComplexVector Applied(const Cycle& cycle, const ComplexVector& b)
{
  const CompactSections right = Compact(b);
  CompactSections result(right.size());
  double product = 0.0;
  cycle.Apply<1>(right.data(), result.data(), 0, &product);
  const ComplexVector wide = Widened(result);
  EXPECT_NEAR(product, Widened(right).dot(wide).real(), 1e-6 * b.norm() * wide.norm());
  return wide;
}

Eigen::MatrixXcd Dense(const LevelMatrices& level, bool mass)
{
  const CompactMatrix& energy = level.Energy;
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(energy.Rows(), energy.Rows());
  for (Index i = 0; i < energy.Rows(); ++i)
  {
    matrix(i, i) = mass ? level.MassDiagonal[i] : energy.Diagonal[i];
    for (Index k = energy.Begin[i]; k < energy.Begin[i + 1]; ++k)
    {
      matrix(i, energy.Column[k]) = mass ? level.MassValue[k] : energy.Value[k];
    }
  }
  return matrix;
}

Eigen::MatrixXcd Dense(const Prolongator& p)
{
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(p.FineRows(), p.CoarseRows());
  for (Index i = 0; i < p.FineRows(); ++i)
  {
    for (Index k = p.Begin[i]; k < p.Begin[i + 1]; ++k)
    {
      matrix(i, p.Column[k]) = p.Value[k];
    }
  }
  return matrix;
}

EigenpairSettings Settings(const System& system)
{
  EigenpairSettings settings;
  settings.Scale = system.Scale;
  return settings;
}

Eigenpair ByMultigrid(const System& system)
{
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  LowestSections lowest;
  return SolveByJacobiDavidson(system.Matrices, hierarchy, Settings(system), {}, lowest);
}

/// Meshes that multigrid has to cope with: well shaped, with boundary, flat, obtuse, slivers, needles,
/// coarse triangles beside fine ones.
std::map<std::string, Surface> Cases()
{
  const Eigen::Vector3d squeezed(1.0, 1.0, 0.1);
  const Eigen::Vector3d stretched(1.0, 1.0, 8.0);
  return { { "potato", Potato(5) }, { "hemisphere", Hemisphere(5) }, { "disk", Disk(50) },
    { "torus", Torus(150, 60) }, { "thin torus", Torus(800, 12, 1.0, 0.1) },
    { "squeezed", Transformed(Potato(5), squeezed.asDiagonal(), Vector3::Zero()) },
    { "stretched", Transformed(Potato(5), stretched.asDiagonal(), Vector3::Zero()) },
    { "jittered", Jittered(Potato(5), 0.02, 7) }, { "genus 2", FlatlySubdivided(DoubleTorus(), 1) },
    { "plate", PlateWithHole(240, 24, 0.3, true) }, { "L", LShape(80) },
    { "cube", FlatlySubdivided(Cube(), 5) } };
}
}

TEST(Multigrid, CoarseMatricesAreProjections)
{
  const System system(Potato(3), 4, 0.3);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const std::vector<Hierarchy::Level>& levels = hierarchy.GetLevels();
  ASSERT_GE(levels.size(), 2u);
  EXPECT_LT(levels[1].Rows() * 3, levels[0].Rows());
  const Eigen::MatrixXcd p = Dense(levels[0].FromCoarser);
  const Eigen::MatrixXcd energy = p.adjoint() * Eigen::MatrixXcd(system.Matrices.Energy) * p;
  const Eigen::MatrixXcd mass = p.adjoint() * Eigen::MatrixXcd(system.Matrices.Mass) * p;
  EXPECT_LT((Dense(levels[1].Matrices, false) - energy).norm(), 1e-6 * energy.norm());
  EXPECT_LT((Dense(levels[1].Matrices, true) - mass).norm(), 1e-6 * mass.norm());

  const CompactSections x = Compact(RandomVector(p.rows(), 1));
  CompactSections restricted(2 * p.cols());
  levels[0].FromCoarser.Restrict<1>(x.data(), restricted.data());
  EXPECT_LT((Widened(restricted) - p.adjoint() * Widened(x)).norm(), 1e-5 * restricted.size());
}

TEST(Multigrid, InterpolatesParallelSectionsExactly)
{
  // On a flat disk the transported section is parallel, and smoothing keeps what the energy maps to
  // zero; the section is interpolated from its values averaged over the aggregates.
  const System system(Disk(30), 4, 0.0);
  const ComplexVector parallel = ByMultigrid(system).Vector;
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const Eigen::MatrixXcd p = Dense(hierarchy.GetLevels()[0].FromCoarser);
  const ComplexVector nearest =
    p * (p.adjoint() * p).ldlt().solve(p.adjoint() * parallel);
  EXPECT_LT((nearest - parallel).norm(), 1e-3 * parallel.norm());
}

/// Its factor would take a fifth of a slider's move.
TEST(Multigrid, CoarsestMatricesAreSmallAtAnySize)
{
  for (int cells = 20; cells <= 160; cells += 7)
  {
    const System system(Torus(cells, cells), 4, 0.0);
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    EXPECT_LE(hierarchy.GetLevels().back().Rows(), Hierarchy::CoarsestRows) << cells;
    EXPECT_GE(hierarchy.GetLevels().back().Rows(), 2 * SectionBlock::Width) << cells;
  }
}

TEST(Multigrid, CyclesAreSymmetricAndPositive)
{
  for (const double shift : { 0.0, 0.05 })
  {
    const System system(Potato(6), 4, 0.0);
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    // The third level is corrected twice.
    ASSERT_GE(hierarchy.GetLevels().size(), 4u);
    const Cycle cycle(hierarchy, shift);
    ASSERT_TRUE(cycle.IsUsable());
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
      const ComplexVector a = RandomVector(system.Matrices.Energy.rows(), seed);
      const ComplexVector b = RandomVector(system.Matrices.Energy.rows(), seed + 100);
      const ComplexVector x = Applied(cycle, a);
      const ComplexVector y = Applied(cycle, b);
      EXPECT_LT(std::abs(b.dot(x) - std::conj(a.dot(y))), 1e-4 * b.norm() * x.norm());
      EXPECT_GT(a.dot(x).real(), 0.0);
    }
  }
}

/// The parallel field, of energy 0: not more than the coarsest level's shift allows.
TEST(Multigrid, CyclesAreBoundedWhereTheEigenvalueIsZero)
{
  const System system(Square(60), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const Cycle cycle(hierarchy, 0.0);
  ASSERT_TRUE(cycle.IsUsable());
  const ComplexVector parallel = ByMultigrid(system).Vector;
  EXPECT_LT(parallel.dot(system.Matrices.Energy * parallel).real(), 1e-10 * system.Scale);
  const ComplexVector right = system.Matrices.Mass * parallel;
  const double product = right.dot(Applied(cycle, right)).real();
  EXPECT_GT(product * cycle.GetCoarsestShift(), 0.5);
  EXPECT_LT(product * cycle.GetCoarsestShift(), 1.5);
  EXPECT_GT(cycle.GetCoarsestShift(), 1e-3 * system.Scale);
}

/// Also where triangles are stretched, so that a vertex is coupled much more in one direction.
TEST(Multigrid, CyclesReduceTheErrorAtAnySize)
{
  const auto reduce = [](const Surface& surface, double least)
  {
    const System system(surface, 4, 0.0);
    const SparseMatrix& energy = system.Matrices.Energy;
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    EXPECT_LT(hierarchy.OperatorComplexity(), 1.6);
    const Cycle cycle(hierarchy, 0.0);
    // The slowest error, by the power method.
    ComplexVector error = RandomVector(energy.rows(), 3);
    double reduction = 1.0;
    for (int step = 0; step < 30; ++step)
    {
      const double before = std::sqrt(error.dot(energy * error).real());
      error -= Applied(cycle, energy * error);
      reduction = std::sqrt(error.dot(energy * error).real()) / before;
      error /= error.norm();
    }
    EXPECT_LT(reduction, least) << energy.rows();
  };
  // Smoothed aggregation alone comes to 0.63, couplings of 0.02 taken for strong to 0.67.
  for (const int levels : { 3, 4, 5, 6 })
  {
    reduce(Potato(levels), 0.6);
  }
  // Those to 0.87.
  reduce(Torus(600, 60), 0.65);
}

TEST(Multigrid, FindsTheEigenvaluesOfTheDirectSolver)
{
  for (const auto& [name, surface] : Cases())
  {
    for (const int degree : { 1, 4 })
    {
      const System system(surface, degree, 0.0);
      const Eigenpair fast = ByMultigrid(system);
      const Eigenpair direct = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
        RandomVector(system.Matrices.Energy.rows(), 5), Settings(system));
      EXPECT_LE(fast.Residual, 1e-6) << name << degree;
      EXPECT_NEAR(fast.Value, direct.Value, 1e-9 * direct.Value + 1e-12 * system.Scale)
        << name << degree;
      EXPECT_NEAR(fast.Vector.dot(system.Matrices.Mass * fast.Vector).real(), 1.0, 1e-12);
    }
  }
}

TEST(Multigrid, TakesFewCyclesWhateverTheMeshAndTheDegree)
{
  // Most take 10 to 15; more where many smallest eigenvalues lie together, as those of nearly
  // holomorphic fields do.
  const auto count = [&](const Surface& surface, int degree, double bias, const std::string& name)
  {
    const Eigenpair pair = ByMultigrid(System(surface, degree, bias));
    EXPECT_LE(pair.Residual, 1e-6) << name << " n = " << degree << ", s = " << bias;
    EXPECT_LE(pair.Iterations, 36) << name << " n = " << degree << ", s = " << bias;
    EXPECT_GE(pair.Iterations, 4) << name;
  };
  for (const auto& [name, surface] : Cases())
  {
    count(surface, 4, 0.0, name);
  }
  for (const int degree : { 1, 2, 3, 4, 5, 6 })
  {
    for (const double bias : { -0.9, 0.0, 0.9 })
    {
      count(Cases().at("potato"), degree, bias, "potato");
    }
  }
}

/// On a round sphere the smallest 2 n + 1 eigenvalues differ by the discretization only.
TEST(Multigrid, SeparatesNearlyEqualEigenvalues)
{
  for (const int degree : { 1, 2, 3, 4, 5, 6 })
  {
    for (const double bias : { -0.9, 0.0, 0.9 })
    {
      const System system(Icosphere(5), degree, bias);
      const Hierarchy hierarchy(system.Matrices, system.Scale);
      LowestSections lowest;
      const Eigenpair fast =
        SolveByJacobiDavidson(system.Matrices, hierarchy, Settings(system), {}, lowest);
      EXPECT_LE(fast.Residual, 1e-6) << degree << ", " << bias;
      // Of three or five eigenvectors the four sections lack one at most.
      EXPECT_LE(fast.Iterations, degree <= 2 ? 12 : 170) << degree << ", " << bias;
      const Eigenpair direct = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
        RandomVector(system.Matrices.Energy.rows(), 5), Settings(system));
      EXPECT_NEAR(fast.Value, direct.Value, 1e-9 * direct.Value) << degree << ", " << bias;

      SectionBlock block(static_cast<Index>(fast.Vector.size()));
      block.Vectors = lowest.Vectors;
      Multiply(system.Matrices, block.Vectors.data(), block.Energy.data(), block.Mass.data());
      const std::vector<SmallMatrix> products = InnerProducts(block.Rows(),
        { { &block.Vectors, &block.Energy }, { &block.Vectors, &block.Mass } });
      for (int b = 0; b < SectionBlock::Width; ++b)
      {
        EXPECT_NEAR(products[0](b, b).real() / products[1](b, b).real(), lowest.Values[b],
          1e-4 * lowest.Values[b])
          << degree << ", " << bias << ", " << b;
      }
    }
  }
}

TEST(Multigrid, AnIndefiniteMatrixIsShownByASection)
{
  const System system(Potato(5), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const Cycle cycle(hierarchy, 0.0);
  // Zero sections deflate nothing.
  SectionBlock none(hierarchy.GetLevels()[0].Rows());
  for (CompactSections* sections : { &none.Vectors, &none.Energy })
  {
    sections->assign(sections->size(), 0.0f);
  }
  DeflatedGradients gradients(hierarchy.GetLevels()[0], cycle, none);
  const Eigenpair smallest = ByMultigrid(system);
  for (const double part : { 0.5, 1.5 })
  {
    const double shift = part * smallest.Value;
    SolveCounter cycles;
    ComplexVector solution;
    const DeflatedGradients::Outcome outcome = gradients.Solve(
      RandomVector(none.Rows(), 3), -shift, 1e-5, 100, cycles, solution);
    const double form = solution.dot(system.Matrices.Energy * solution).real() -
      shift * solution.dot(system.Matrices.Mass * solution).real();
    EXPECT_EQ(outcome.Indefinite, part > 1.0);
    EXPECT_EQ(form < 0.0, part > 1.0);
  }
}

TEST(Multigrid, TheEigenvalueIsNearlyKnownBeforeSingleSectionsAre)
{
  // Where fields are concentrated on a part of the surface, as with s = 0.9, interpolation adds much.
  for (const double bias : { -0.9, 0.0, 0.9 })
  {
    const System system(Potato(5), 4, bias);
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    const Cycle cycle(hierarchy, 0.0);
    const NestedPairs pairs =
      IterateNested(system.Matrices, hierarchy, cycle, {});
    ASSERT_EQ(pairs.Values.size(), SectionBlock::Width);
    const double smallest = ByMultigrid(system).Value;
    EXPECT_GT(pairs.Values[0], smallest);
    EXPECT_LT(pairs.Values[0], 1.01 * smallest) << bias;
  }
}

TEST(Multigrid, WhatIsLeftOutOfAnEquationIsExact)
{
  const System system(Potato(5), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const Cycle cycle(hierarchy, 0.0);
  const Hierarchy::Level& finest = hierarchy.GetLevels()[0];
  const auto rows = static_cast<Eigen::Index>(finest.Rows());
  // Sections that are far from eigenvectors.
  SectionBlock block(finest.Rows());
  block.Vectors.assign(block.Vectors.size(), 0.0f);
  Eigen::MatrixXcd sections(rows, 3);
  for (int b = 0; b < 3; ++b)
  {
    CompactSections rough(2 * rows);
    CompactSections smooth(2 * rows);
    const ComplexVector random = RandomVector(rows, static_cast<unsigned>(b));
    for (Eigen::Index v = 0; v < rows; ++v)
    {
      rough[2 * v] = static_cast<float>(random[v].real());
      rough[2 * v + 1] = static_cast<float>(random[v].imag());
    }
    cycle.Apply<1>(rough.data(), smooth.data());
    for (Eigen::Index v = 0; v < rows; ++v)
    {
      sections(v, b) = Complex(smooth[2 * v], smooth[2 * v + 1]);
      block.Vectors[8 * v + b + 1] = smooth[2 * v];
      block.Vectors[8 * v + b + 5] = smooth[2 * v + 1];
    }
  }
  Multiply(system.Matrices, block.Vectors.data(), block.Energy.data(), block.Mass.data());
  DeflatedGradients gradients(finest, cycle, block);
  const ComplexVector b = RandomVector(rows, 7);
  const double shift = -0.5 * ByMultigrid(system).Value;
  const double reduction = 1e-4;
  ComplexVector solution;
  SolveCounter cycles;
  gradients.Solve(b, shift, reduction, 100, cycles, solution);
  const Eigen::VectorXd lumped =
    Eigen::Map<const Eigen::VectorXf>(finest.LumpedMass.data(), rows).cast<double>();
  const auto times = [&](const Eigen::MatrixXcd& x) -> Eigen::MatrixXcd
  { return system.Matrices.Energy * x + shift * (lumped.asDiagonal() * x); };
  // The solution of the whole equation is short of sections that were left out only.
  const Eigen::MatrixXcd products = times(sections);
  const ComplexVector rest = b - times(solution);
  const Eigen::VectorXcd missing =
    (sections.adjoint() * products).ldlt().solve(sections.adjoint() * rest);
  EXPECT_LT((rest - products * missing).norm(), 1.1 * reduction * b.norm());
}

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

TEST(Multigrid, SmallComponentsAreSolvedDirectlyByAutomatic)
{
  Options options;
  options.NumberOfThreads = 2;
  const Result result =
    DirectionField(Joined(Potato(2), Potato(5))).Compute(options);
  EXPECT_EQ(result.Components[0].SolverUsed, Solver::Direct);
  EXPECT_EQ(result.Components[1].SolverUsed, Solver::Multigrid);
  options.Solver = Solver::Direct;
  EXPECT_EQ(DirectionField(Potato(5)).Compute(options).Components[0].SolverUsed, Solver::Direct);
}

TEST(Multigrid, StopsWhenTold)
{
  const System system(Potato(5), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  LowestSections lowest;
  int calls = 0;
  const ProgressFunction stop = [&](double) { return ++calls < 20; };
  EXPECT_THROW(SolveByJacobiDavidson(
                 system.Matrices, hierarchy, Settings(system), Progress(stop), lowest),
    Stopped);
  EXPECT_EQ(calls, 20);
}

/// Products that a coarse matrix consists of may be added up in another order below the diagonal.
TEST(Multigrid, CouplingsMayBeStrongOnOneSideOnly)
{
  Eigen::MatrixXcd energy(3, 3);
  energy << 1.0, -0.5, 0.0, -0.5, 1.0, -0.020001, 0.0, -0.020001, 1.0;
  LevelMatrices matrices;
  matrices.Energy = CompactMatrix(SparseMatrix(energy.sparseView()));
  matrices.MassValue.assign(matrices.Energy.Value.size(), 1.0f);
  matrices.MassDiagonal.assign(3, 1.0f);
  // The last row's.
  matrices.Energy.Value[matrices.Energy.Begin[2]] = -0.019999f;
  const Prolongator p = MakeProlongator(matrices, 0, LeftOver::Drop);
  EXPECT_EQ(p.CoarseRows(), 1);
  const std::vector<Index> begin(p.Begin.begin(), p.Begin.end());
  EXPECT_EQ(begin, (std::vector<Index>{ 0, 1, 2, 2 }));
  EXPECT_EQ(p.Column[0], 0);
  EXPECT_EQ(p.Column[1], 0);
}

/// Pairs whose couplings become strong one after the other, as what counts as strong gets weaker.
TEST(Multigrid, CoarseningEndsWhereItIsOfNoUse)
{
  constexpr Index pairs = 4000;
  Operators operators;
  for (SparseMatrix* const matrix : { &operators.Energy, &operators.Mass })
  {
    const double sign = matrix == &operators.Energy ? -1.0 : 1.0;
    std::vector<Eigen::Triplet<Complex>> entries;
    for (Index k = 0; k < pairs; ++k)
    {
      const double coupling = sign * std::pow(10.0, -1.0 - 6.0 * k / pairs);
      for (const Index row : { 2 * k, 2 * k + 1 })
      {
        entries.emplace_back(row, row, 1.0);
        entries.emplace_back(row, 4 * k + 1 - row, coupling);
      }
    }
    matrix->resize(2 * pairs, 2 * pairs);
    matrix->setFromTriplets(entries.begin(), entries.end());
  }
  const Hierarchy hierarchy(operators, 1.0);
  EXPECT_LE(hierarchy.GetLevels().size(), 3u);
  EXPECT_FALSE(Cycle(hierarchy, 0.0).IsUsable());
}
