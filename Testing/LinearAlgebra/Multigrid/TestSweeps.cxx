// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Multigrid/Sweeps.h"
#include "Systems/ConjugateGradients.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// So many points move to where the opposite edge of a triangle nearly is.
Surface WithSlivers(Surface surface, int count)
{
  const auto triangles = static_cast<Index>(surface.Triangles.size());
  for (int k = 0; k < count; ++k)
  {
    const Triangle& triangle = surface.Triangles[static_cast<std::size_t>(k) * triangles / count];
    Vector3& point = surface.Points[triangle[0]];
    point += 0.99 * (0.5 * surface.Points[triangle[1]] + 0.5 * surface.Points[triangle[2]] - point);
  }
  return surface;
}
}

/// Of several blocks of rows, with local ones.
TEST(Sweeps, InOppositeOrdersAreAdjoint)
{
  const System system(WithSlivers(Potato(6), 100), 4, 0.0);
  const Hierarchy hierarchy(system.Matrices, system.Scale);
  const Hierarchy::Level& finest = hierarchy.GetLevels()[0];
  const CompactMatrix& matrix = finest.Matrices.Energy;
  const auto rows = static_cast<std::size_t>(matrix.Rows());
  ASSERT_GT(matrix.Rows(), 2 * CompactMatrix::BlockRows);
  EXPECT_GT(matrix.Boundary.size(), 10u);
  EXPECT_LT(matrix.Boundary.size(), rows / 4);
  EXPECT_GT(matrix.Local.size(), 50u);
  EXPECT_GT(std::count_if(matrix.Local.begin(), matrix.Local.end(),
              [](const CompactMatrix::LocalRow& local) { return local.Boundary != None; }),
    0);
  const double shift = 3.0 * system.Scale;
  const SweepDiagonal diagonal(matrix, finest.LumpedMass, static_cast<float>(shift));
  const ComplexVector b = RandomVector(matrix.Rows(), 1);
  const ComplexVector c = RandomVector(matrix.Rows(), 2);
  CompactSections down(2 * rows);
  CompactSections up(2 * rows, 0.0f);
  SweepFromZero<1>(matrix, diagonal, Compact(b).data(), down.data());
  Sweep<1>(matrix, diagonal, SweepOrder::Up, Compact(c).data(), up.data());
  const Complex one = c.dot(Widened(down));
  const Complex other = Widened(up).dot(b);
  EXPECT_LT(std::abs(one - other), 1e-5 * b.norm() * Widened(up).norm());

  const auto restOf = [&](const CompactSections& x)
  {
    const ComplexVector wide = Widened(x);
    ComplexVector rest = b - system.Matrices.Energy * wide;
    for (Index v = 0; v < matrix.Rows(); ++v)
    {
      rest[v] -= shift * finest.LumpedMass[v] * wide[v];
    }
    return rest;
  };
  // To go on from x is to add the sweep's solution for the residual. Both return the new residual.
  const ComplexVector before = restOf(up);
  CompactSections correction(2 * rows);
  CompactSections left(2 * rows);
  CompactSections rest(2 * rows);
  SweepFromZero<1>(matrix, diagonal, Compact(before).data(), correction.data(), left.data());
  const ComplexVector sum = Widened(up) + Widened(correction);
  Sweep<1>(matrix, diagonal, SweepOrder::Down, Compact(b).data(), up.data(), rest.data());
  EXPECT_LT((Widened(up) - sum).norm(), 1e-5 * sum.norm());
  const ComplexVector after = restOf(up);
  EXPECT_GT((after - before).norm(), 0.1 * before.norm());
  EXPECT_LT((Widened(rest) - after).norm(), 1e-5 * after.norm());
  EXPECT_LT((Widened(left) - after).norm(), 1e-5 * after.norm());
}

/// Though coarser levels correct slivers badly.
TEST(Sweeps, AFewSliversCostFewSteps)
{
  const auto steps = [](const Surface& surface)
  {
    const System system(surface, 4, 0.0);
    const Hierarchy hierarchy(system.Matrices, system.Scale);
    ReducedBasis solved;
    int asked = 0;
    const ProgressFunction count = [&](double) { return ++asked > 0; };
    const ShiftedSystem shifted{ system.Matrices, 1.0, system.Scale, 1e-6, Progress(count) };
    const ComplexVector b = system.Matrices.Mass * RandomVector(system.Matrices.Energy.rows(), 1);
    EXPECT_LE(ConjugateGradients(shifted, hierarchy, {}, b, solved).Residual, 1e-6);
    return asked;
  };
  const int least = steps(Potato(6));
  EXPECT_LE(least, 12);
  // Without local sweeps 23 and 27.
  EXPECT_LE(steps(WithSlivers(Potato(6), 40)), least + 1);
  EXPECT_LE(steps(WithSlivers(Potato(6), 100)), least + 5);
}
