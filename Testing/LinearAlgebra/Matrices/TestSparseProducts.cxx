// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/SparseProducts.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using namespace Meshes;

TEST(SparseProducts, AreThoseOfEigen)
{
  const System system(Potato(4), 4, 0.5);
  const SparseMatrix& a = system.Matrices.Energy;
  std::vector<Index> chosen;
  for (Index v = 0; v < static_cast<Index>(a.cols()); v += 1 + v % 3)
  {
    chosen.push_back(v);
  }
  // More columns than a thread takes at once.
  ASSERT_GT(chosen.size(), 1000u);
  const SparseMatrix b = SelectedColumns(system.Matrices.Mass, chosen);
  ASSERT_EQ(b.rows(), a.rows());
  ASSERT_EQ(b.cols(), static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t k = 0; k < chosen.size(); k += 100)
  {
    EXPECT_EQ(
      (b.col(static_cast<Eigen::Index>(k)) - system.Matrices.Mass.col(chosen[k])).norm(), 0.0);
  }
  const SparseMatrix expected = a * b;
  const SparseMatrix product = SparseProduct(a, b);
  EXPECT_EQ(product.nonZeros(), expected.nonZeros());
  EXPECT_LT((product - expected).norm(), 1e-14 * expected.norm());
}

TEST(SparseProducts, TheNormalMatrixIsAsDenseAsItsRowsAreLong)
{
  // Rows of two entries couple an unknown with two in the mean, itself and another one.
  SparseMatrix adjoint(5, 4);
  for (Index row = 0; row < 4; ++row)
  {
    adjoint.insert(row, row) = 1.0;
    adjoint.insert(row + 1, row) = 1.0;
  }
  adjoint.makeCompressed();
  EXPECT_TRUE(IsNormalMatrixSparse(adjoint, 2.0));
  EXPECT_FALSE(IsNormalMatrixSparse(adjoint, 1.9));
  // One row of all five unknowns: (2 + 2 + 2 + 5 * 5) / (6 + 5) for rows of 2, 2, 2 and 5.
  for (Index v = 0; v < 3; ++v)
  {
    adjoint.insert(v, 3) = 1.0;
  }
  adjoint.makeCompressed();
  EXPECT_TRUE(IsNormalMatrixSparse(adjoint, 37.0 / 11.0 + 1e-9));
  EXPECT_FALSE(IsNormalMatrixSparse(adjoint, 37.0 / 11.0 - 1e-9));
}
