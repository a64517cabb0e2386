// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/WorkLimit.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

/// Below the diagonal, as the factorization itself counts them.
TEST(FactorWork, CountsTheEntriesOfTheFactor)
{
  for (const Surface& surface : { Potato(4), Square(40), Torus(60, 20) })
  {
    const System system(surface, 4, 0.0);
    const SparseMatrix matrix = system.Matrices.Energy + system.Matrices.Mass;
    const FactorWork work(matrix);
    const Eigen::SimplicialLDLT<SparseMatrix> factor(matrix);
    const SparseMatrix lower = factor.matrixL();
    EXPECT_EQ(work.Entries, static_cast<double>(lower.nonZeros() - lower.cols()));
    EXPECT_GT(work.Operations, work.Entries);
    EXPECT_LT(work.Operations, work.Entries * work.Rows);
  }
}

/// That of the direct solver grows by more than the rows do.
TEST(FactorWork, GrowsFasterThanTheSurface)
{
  const System small(Potato(4), 4, 0.0);
  const System large(Potato(6), 4, 0.0);
  const WorkLimit ofSmall(small.Matrices.Energy, 20, 150.0);
  const WorkLimit ofLarge(large.Matrices.Energy, 20, 150.0);
  EXPECT_GT(ofLarge.Get(), 20.0 * ofSmall.Get());
}

TEST(WorkLimit, IsThatOfTheOtherSolver)
{
  const System system(Potato(6), 4, 0.0);
  const WorkLimit limit(system.Matrices.Energy, 20, 150.0);
  const double most = limit.Get();
  EXPECT_TRUE(limit.Allows(most));
  EXPECT_FALSE(limit.Allows(1.01 * most));
  // Work that is foreseen to take longer ends early, though not at once.
  EXPECT_TRUE(limit.Allows(0.1 * most, Infinity));
  EXPECT_FALSE(limit.Allows(0.5 * most, Infinity));
  EXPECT_TRUE(limit.Allows(0.5 * most, 0.5 * most));
  // Work that takes next to no time is not judged.
  const System tiny(Potato(2), 4, 0.0);
  EXPECT_TRUE(WorkLimit(tiny.Matrices.Energy, 20, 150.0).Allows(2e7, Infinity));
}

TEST(WorkLimit, TheResidualTellsWhatRemains)
{
  // Three digits took 6, so three more take as long.
  EXPECT_NEAR(RemainingWork(6.0, 1.0, 1e-3, 1e-6), 6.0, 1e-12);
  EXPECT_EQ(RemainingWork(6.0, 1.0, 1e-7, 1e-6), 0.0);
  EXPECT_EQ(RemainingWork(6.0, 1.0, 1.0, 1e-6), Infinity);
  EXPECT_EQ(RemainingWork(6.0, 1.0, 2.0, 1e-6), Infinity);
}
