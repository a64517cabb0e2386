// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"
#include "Meshes/DenseAlgebra.h"
#include "Meshes/Surfaces.h"
#include "Systems/DirectSystem.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>

using namespace DirectionFields;
using namespace Meshes;

TEST(ConstraintSystems, SolutionsEqualDenseMinimization)
{
  std::mt19937 engine(5);
  const auto random = [&] { return std::polar(1.0, engine() / 4294967296.0 * 2.0 * Pi); };
  for (const Surface& surface : { Potato(1), Hemisphere(1), Disk(4) })
  {
    for (const double shift : { 0.0, 2.0 })
    {
      Stages stages(surface);
      Options options;
      options.EnergyBias = 0.3;
      const Operators& operators = stages.GetEnergy(options, {}).Components[0].GetMatrices();
      const SparseMatrix k = operators.Energy + shift * operators.Mass;
      const auto n = static_cast<Index>(k.rows());
      ComplexVector b = ComplexVector::Zero(n);
      GivenValues given;
      given.Values.resize((n + 4) / 5);
      std::vector<Index> free;
      for (Index v = 0; v < n; ++v)
      {
        b[v] = shift * random();
        if (v % 5 == 0)
        {
          given.Values[static_cast<Eigen::Index>(given.Vertices.size())] = random();
          given.Vertices.push_back(v);
        }
        else
        {
          free.push_back(v);
        }
      }
      const Eigen::MatrixXcd dense(k);
      const Eigen::MatrixXcd columns = dense(Eigen::indexing::all, free);
      const ComplexVector right = b - dense(Eigen::indexing::all, given.Vertices) * given.Values;

      const SystemSolution least = MinimizeResidualDirectly(k, b, given);
      const ComplexVector denseLeast = DenseLeastSquares(columns, right);
      EXPECT_LT((least.Vector(free) - denseLeast).norm(), 1e-9 * denseLeast.norm());
      EXPECT_LT((columns.adjoint() * (dense * least.Vector - b)).norm(),
        1e-8 * (columns.adjoint() * right).norm());
      EXPECT_LE(least.Residual, 1e-10);

      const SystemSolution energy = MinimizeEnergyDirectly(k, b, given);
      const ComplexVector denseEnergy =
        DenseSolution(columns(free, Eigen::indexing::all), ComplexVector(right(free)));
      EXPECT_LT((energy.Vector(free) - denseEnergy).norm(), 1e-9 * denseEnergy.norm());
      EXPECT_LE(energy.Residual, 1e-10);
      for (const SystemSolution& s : { least, energy })
      {
        EXPECT_EQ(ComplexVector(s.Vector(given.Vertices)), given.Values);
      }
      const auto objective = [&](const ComplexVector& u)
      { return u.dot(k * u).real() - 2.0 * b.dot(u).real(); };
      EXPECT_LE(objective(energy.Vector), objective(least.Vector));
      EXPECT_LE((k * least.Vector - b).norm(), (k * energy.Vector - b).norm());
    }
  }
}
