// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/RitzSpace.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Multigrid/LevelMatrices.h"

#include <gtest/gtest.h>

#include <limits>

using namespace DirectionFields;
using namespace Meshes;

TEST(RitzSpace, HasTheRitzPairsOfItsSections)
{
  const System system(Potato(3), 4, 0.0);
  const Eigen::Index n = system.Matrices.Energy.rows();
  Eigen::MatrixXcd sections(n, 6);
  RitzSpace space(system.Matrices);
  for (Eigen::Index k = 0; k < sections.cols(); ++k)
  {
    sections.col(k) = RandomVector(n, static_cast<unsigned>(k));
    space.Add(sections.col(k));
  }
  // Sections that are in the space already do not count.
  space.Add(sections.col(1) - Complex(0.0, 3.0) * sections.col(4));
  EXPECT_EQ(space.Size(), 6);
  const Eigen::VectorXd expected =
    DenseEigenpairs(sections.adjoint() * system.Matrices.Energy * sections,
      sections.adjoint() * system.Matrices.Mass * sections)
      .Values;
  ASSERT_EQ(space.GetValues().size(), 6);
  EXPECT_LT((space.GetValues() - expected).norm(), 1e-12 * expected.norm());

  SectionBlock block(static_cast<Index>(n));
  // All but the first section are written.
  block.Vectors.assign(block.Vectors.size(), 0.0f);
  block.Energy.assign(block.Energy.size(), 0.0f);
  const SectionProducts first = space.First(block);
  EXPECT_LT(
    (first.Energy - system.Matrices.Energy * first.Vector).norm(), 1e-12 * first.Energy.norm());
  EXPECT_LT((first.Mass - system.Matrices.Mass * first.Vector).norm(), 1e-12 * first.Mass.norm());
  const ComplexVector rest = first.Energy - space.GetValues()[0] * first.Mass;
  EXPECT_LT((sections.adjoint() * rest).norm(), 1e-10 * sections.norm() * first.Energy.norm());

  SectionBlock multiplied(static_cast<Index>(n));
  Multiply(system.Matrices, block.Vectors.data(), multiplied.Energy.data(), multiplied.Mass.data());
  const std::vector<SmallMatrix> products = InnerProducts(block.Rows(),
    { { &block.Vectors, &multiplied.Mass }, { &block.Vectors, &block.Energy },
      { &block.Vectors, &multiplied.Energy } });
  SmallMatrix unit = SmallMatrix::Identity(4, 4);
  unit(0, 0) = 0.0;
  EXPECT_LT((products[0] - unit).norm(), 1e-5);
  for (int b = 1; b < SectionBlock::Width; ++b)
  {
    EXPECT_NEAR(products[1](b, b).real(), space.GetValues()[b], 1e-5 * space.GetValues()[b]);
    EXPECT_NEAR(products[2](b, b).real(), space.GetValues()[b], 1e-5 * space.GetValues()[b]);
  }
}

TEST(RitzSpace, KeepsTheSmallestValues)
{
  const System system(Potato(3), 4, 0.0);
  RitzSpace space(system.Matrices);
  double before = std::numeric_limits<double>::infinity();
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    space.Add(RandomVector(system.Matrices.Energy.rows(), seed));
    EXPECT_LE(space.Size(), RitzSpace::MostSections);
    // The largest ones are forgotten.
    EXPECT_LT(space.GetValues()[0], before * (1.0 + 1e-12));
    before = space.GetValues()[0];
  }
}
