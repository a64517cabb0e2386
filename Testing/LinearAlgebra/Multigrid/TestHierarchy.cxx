// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LinearAlgebra/ByMultigrid.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"
#include "Multigrid/Cycle.h"
#include "Multigrid/SmoothedAggregation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
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
}

TEST(Hierarchy, CoarseMatricesAreProjections)
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

TEST(Hierarchy, InterpolatesParallelSectionsExactly)
{
  // On a flat disk the transported section is parallel, and smoothing keeps what the energy maps to
  // zero; the section is interpolated from its values averaged over the aggregates.
  const System system(Disk(30), 4, 0.0);
  const ComplexVector parallel = ByMultigrid(system).Vector;
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const Eigen::MatrixXcd p = Dense(hierarchy.GetLevels()[0].FromCoarser);
  const ComplexVector nearest = p * DenseSolution(p.adjoint() * p, p.adjoint() * parallel);
  EXPECT_LT((nearest - parallel).norm(), 1e-3 * parallel.norm());
}

/// Its factor would take a fifth of a slider's move.
TEST(Hierarchy, CoarsestMatricesAreSmallAtAnySize)
{
  for (int cells = 20; cells <= 160; cells += 7)
  {
    const System system(Torus(cells, cells), 4, 0.0);
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    EXPECT_LE(hierarchy.GetLevels().back().Rows(), Hierarchy::CoarsestRows) << cells;
    EXPECT_GE(hierarchy.GetLevels().back().Rows(), 2 * SectionBlock::Width) << cells;
  }
}

/// Products that a coarse matrix consists of may be added up in another order below the diagonal.
TEST(Hierarchy, CouplingsMayBeStrongOnOneSideOnly)
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

/// Pairs whose couplings become strong one after the other, as the threshold of strong couplings falls.
TEST(Hierarchy, CoarseningEndsWhereItIsOfNoUse)
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
  // Sweeps solve for the rest.
  const Cycle cycle(hierarchy, 0.0);
  EXPECT_TRUE(cycle.IsUsable());
  EXPECT_LT(cycle.GetCoarsest().GetContraction(), 0.1);
  EXPECT_EQ(cycle.GetCoarsest().GetPairs(), 1);
}

/// Where the holonomies about vertices are large and random, parallel transport says little about the next
/// but one vertex: aggregates of the second level would be single vertices.
TEST(Hierarchy, StaysSmallOnRoughSurfaces)
{
  for (const Surface& surface : { Potato(5), Torus(150, 60), Square(100) })
  {
    const System smooth(surface, 4, 0.0);
    const Hierarchy ofSmooth(smooth.Matrices, smooth.Scale);
    const double ordinary = Cycle(ofSmooth, 0.0).Work();
    for (const double noise : { 0.3, 1.0, 3.0, 10.0 })
    {
      const System system(Roughened(surface, noise, 1), 4, 0.0);
      for (const LeftOver leftOver : { LeftOver::Keep, LeftOver::Drop })
      {
        const Hierarchy hierarchy(system.Matrices, system.Scale, leftOver);
        const std::vector<Hierarchy::Level>& levels = hierarchy.GetLevels();
        EXPECT_LE(levels.size(), 5u) << noise;
        EXPECT_LE(hierarchy.OperatorComplexity(), 1.8) << noise;
        for (std::size_t l = 1; l < levels.size(); ++l)
        {
          EXPECT_LE(levels[l].Rows(), 0.7 * levels[l - 1].Rows()) << noise << ", level " << l;
        }
        const Cycle cycle(hierarchy, 0.0);
        EXPECT_TRUE(cycle.IsUsable()) << noise;
        EXPECT_LE(cycle.Work(), 3.0 * ordinary) << noise;
        EXPECT_LE(cycle.GetCoarsest().GetContraction(), 0.95) << noise;
      }
    }
  }
}

/// Aggregation would read phase 1 off entries that are zero, and cycles would hardly reduce errors.
TEST(Hierarchy, RefusesAMassMatrixThatDoesNotTellTheTransport)
{
  const System system(Potato(4), 4, 0.0);
  const auto message = [&](const SparseMatrix& mass) -> std::string
  {
    Operators operators;
    operators.Energy = system.Matrices.Energy;
    operators.Mass = mass;
    try
    {
      const Hierarchy hierarchy(operators, system.Scale);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(system.Matrices.Mass), "");
  // The mass matrix lumped into its diagonal, with entries for edges that are zero, and without.
  SparseMatrix lumped = system.Matrices.Mass;
  for (Eigen::Index v = 0; v < lumped.cols(); ++v)
  {
    double sum = 0.0;
    for (SparseMatrix::InnerIterator it(lumped, v); it; ++it)
    {
      sum += std::abs(it.value());
      it.valueRef() = 0.0;
    }
    lumped.coeffRef(v, v) = sum;
  }
  ASSERT_EQ(lumped.nonZeros(), system.Matrices.Mass.nonZeros());
  EXPECT_NE(message(lumped).find("The mass matrix is zero at"), std::string::npos);
  EXPECT_NE(message(lumped).find("Do not lump it"), std::string::npos);
  const SparseMatrix diagonal = lumped.pruned();
  ASSERT_EQ(diagonal.nonZeros(), diagonal.cols());
  EXPECT_NE(message(diagonal).find("entries at different places"), std::string::npos);
  EXPECT_NE(message(diagonal).find("Do not lump it"), std::string::npos);
}

TEST(Hierarchy, TakesMassMatricesWithFewZeros)
{
  const System system(Potato(4), 4, 0.0);
  Operators operators = system.Matrices;
  for (Eigen::Index v = 0; v < operators.Mass.cols(); v += 100)
  {
    SparseMatrix::InnerIterator it(operators.Mass, v);
    const Eigen::Index other = it.row() == v ? (++it).row() : it.row();
    operators.Mass.coeffRef(v, other) = 0.0;
    operators.Mass.coeffRef(other, v) = 0.0;
  }
  EXPECT_NO_THROW(Hierarchy(operators, system.Scale));
}
