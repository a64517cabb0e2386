// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/DeflatedGradients.h"
#include "Eigenpairs/Lanczos.h"
#include "Eigenpairs/NestedIteration.h"
#include "LinearAlgebra/ByMultigrid.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"
#include "Multigrid/LevelMatrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
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

TEST(JacobiDavidson, FindsTheEigenvaluesOfTheDirectSolver)
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

TEST(JacobiDavidson, TakesFewCyclesWhateverTheMeshAndTheDegree)
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

TEST(JacobiDavidson, TakesFewCyclesForStronglyBiasedEnergies)
{
  for (const auto& [name, surface] : Cases())
  {
    for (const double bias : { -0.9, 0.9 })
    {
      const Eigenpair pair = ByMultigrid(System(surface, 6, bias));
      EXPECT_LE(pair.Residual, 1e-6) << name << ", " << bias;
      EXPECT_LE(pair.Iterations, 45) << name << ", " << bias;
    }
  }
}

/// Mixtures of the many sections with small values, and sections of others, pass for that of the smallest value if
/// a residual of the tolerance is all that is asked for.
TEST(JacobiDavidson, FindsTheSmallestPairAtLooseTolerances)
{
  for (const Surface& surface : { Potato(4), Square(60) })
  {
    for (const double noise : { 1.0, 3.0 })
    {
      for (const int degree : { 2, 6 })
      {
        for (const double bias : { -1.0, 0.0, 1.0 })
        {
          const System system(Roughened(surface, noise, 1), degree, bias);
          const double exact = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
            RandomVector(system.Matrices.Energy.rows(), 5), Settings(system))
                                 .Value;
          const Hierarchy hierarchy(system.Matrices, system.Scale);
          for (const double tolerance : { 1e-3, 1e-2, 0.1 })
          {
            EigenpairSettings settings = Settings(system);
            settings.Tolerance = tolerance;
            LowestSections lowest;
            const Eigenpair pair =
              SolveByJacobiDavidson(system.Matrices, hierarchy, settings, {}, lowest);
            EXPECT_TRUE(HasConverged(pair));
            EXPECT_LE(pair.Value, (1.0 + tolerance) * exact)
              << noise << ", " << degree << ", " << bias << ", " << tolerance;
          }
        }
      }
    }
  }
}

/// On a round sphere 17 eigenvalues are nearly the same.
TEST(JacobiDavidson, AsksForASmallerResidualWhereEigenvaluesAreClose)
{
  const System system(Icosphere(4), 8, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  EigenpairSettings settings = Settings(system);
  settings.Tolerance = 0.1;
  LowestSections lowest;
  const Eigenpair pair = SolveByJacobiDavidson(system.Matrices, hierarchy, settings, {}, lowest);
  EXPECT_TRUE(HasConverged(pair));
  EXPECT_LE(pair.RequiredResidual, 1e-5);
  settings.MaximumIterations = pair.Iterations / 2;
  const Eigenpair early = SolveByJacobiDavidson(system.Matrices, hierarchy, settings, {}, lowest);
  EXPECT_LE(early.Residual, settings.Tolerance);
  EXPECT_FALSE(HasConverged(early));
}

/// The smallest sections are concentrated on few triangles each, at places that only their values tell.
TEST(JacobiDavidson, FindsTheSmallestPairOnRoughSurfaces)
{
  for (const Surface& surface : { Potato(5), Torus(150, 60), Square(100) })
  {
    for (const double noise : { 0.3, 1.0, 3.0, 10.0 })
    {
      for (const unsigned seed : { 1, 2, 3 })
      {
        const System system(Roughened(surface, noise, seed), 4, 0.0);
        const Eigenpair fast = ByMultigrid(system);
        const Eigenpair direct = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
          RandomVector(system.Matrices.Energy.rows(), 5), Settings(system));
        EXPECT_LE(fast.Residual, 1e-6) << noise << ", " << seed;
        EXPECT_LE(fast.Iterations, 150) << noise << ", " << seed;
        EXPECT_NEAR(fast.Value, direct.Value, 1e-9 * direct.Value) << noise << ", " << seed;
      }
    }
  }
}

/// Of the 17 smallest pairs of degree 8 on a round sphere, which nearly agree, the four sections lack most.
TEST(JacobiDavidson, EndsWhereTheDirectSolverTakesLess)
{
  const System system(Icosphere(5), 8, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  // As if the direct solver took next to nothing, and all the time there is.
  for (const int solves : { 0, 1000000 })
  {
    const WorkLimit limit(system.Matrices.Energy, solves, 0.0);
    EigenpairSettings settings = Settings(system);
    settings.Limit = &limit;
    LowestSections lowest;
    const Eigenpair pair = SolveByJacobiDavidson(system.Matrices, hierarchy, settings, {}, lowest);
    const Eigenpair unlimited = ByMultigrid(system);
    const double work = pair.Iterations * Cycle(hierarchy, 0.0).Work();
    if (solves == 0)
    {
      EXPECT_GT(pair.Residual, 1e-6);
      EXPECT_LT(pair.Iterations, unlimited.Iterations);
      // 40 cycles may be a step.
      EXPECT_LT(work, limit.Get() + 0.12e9 + 40 * Cycle(hierarchy, 0.0).Work());
    }
    else
    {
      EXPECT_LE(pair.Residual, 1e-6);
      EXPECT_EQ(pair.Iterations, unlimited.Iterations);
      EXPECT_EQ(pair.Vector, unlimited.Vector);
    }
  }
}

/// On a round sphere the smallest 2 n + 1 eigenvalues differ by the discretization only.
TEST(JacobiDavidson, SeparatesNearlyEqualEigenvalues)
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
      const std::vector<SmallMatrix> products = InnerProducts(
        block.Rows(), { { &block.Vectors, &block.Energy }, { &block.Vectors, &block.Mass } });
      for (int b = 0; b < SectionBlock::Width; ++b)
      {
        EXPECT_NEAR(products[0](b, b).real() / products[1](b, b).real(), lowest.Values[b],
          1e-4 * lowest.Values[b])
          << degree << ", " << bias << ", " << b;
      }
    }
  }
}

TEST(JacobiDavidson, TheEigenvalueIsNearlyKnownBeforeSingleSectionsAre)
{
  // Where fields are concentrated on a part of the surface, as with s = 0.9, interpolation adds much.
  for (const double bias : { -0.9, 0.0, 0.9 })
  {
    const System system(Potato(5), 4, bias);
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    const Cycle cycle(hierarchy, 0.0);
    const NestedPairs pairs = IterateNested(system.Matrices, hierarchy, cycle, {});
    ASSERT_EQ(pairs.Values.size(), SectionBlock::Width);
    const double smallest = ByMultigrid(system).Value;
    EXPECT_GT(pairs.Values[0], smallest);
    EXPECT_LT(pairs.Values[0], 1.01 * smallest) << bias;
  }
}

/// A section whose residual is b, for any value.
SectionProducts WithResidual(const ComplexVector& b)
{
  SectionProducts products;
  products.Vector = b;
  products.Energy = -b;
  products.Mass = ComplexVector::Zero(b.size());
  return products;
}

TEST(JacobiDavidson, AnIndefiniteMatrixIsShownByASection)
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
    const ComplexVector b = RandomVector(none.Rows(), 3);
    const DeflatedGradients::Outcome outcome =
      gradients.Solve({ WithResidual(b), shift, b.norm() }, -shift, 1e-5, 100, cycles, solution);
    const double form = solution.dot(system.Matrices.Energy * solution).real() -
      shift * solution.dot(system.Matrices.Mass * solution).real();
    EXPECT_EQ(outcome.Indefinite, part > 1.0);
    EXPECT_EQ(form<0.0, part> 1.0);
  }
}

TEST(JacobiDavidson, WhatIsLeftOutOfAnEquationIsExact)
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
  gradients.Solve({ WithResidual(b), -shift, b.norm() }, shift, reduction, 100, cycles, solution);
  const Eigen::VectorXd lumped =
    Eigen::Map<const Eigen::VectorXf>(finest.LumpedMass.data(), rows).cast<double>();
  const auto times = [&](const Eigen::MatrixXcd& x) -> Eigen::MatrixXcd
  { return system.Matrices.Energy * x + shift * (lumped.asDiagonal() * x); };
  // The solution of the whole equation is short of sections that were left out only.
  const Eigen::MatrixXcd products = times(sections);
  const ComplexVector rest = b - times(solution);
  const Eigen::VectorXcd missing =
    DenseSolution(sections.adjoint() * products, sections.adjoint() * rest);
  EXPECT_LT((rest - products * missing).norm(), 1.1 * reduction * b.norm());
}

TEST(JacobiDavidson, StopsWhenTold)
{
  const System system(Potato(5), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  LowestSections lowest;
  int calls = 0;
  const ProgressFunction stop = [&](double) { return ++calls < 20; };
  EXPECT_THROW(
    SolveByJacobiDavidson(system.Matrices, hierarchy, Settings(system), Progress(stop), lowest),
    Stopped);
  EXPECT_EQ(calls, 20);
}
