// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/CombinedMatrix.h"
#include "Matrices/OperatorProducts.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
void ExpectProducts(const Surface& surface, double a, double m)
{
  const System system(surface, 4, 0.5);
  const SparseMatrix expected = a * system.Matrices.Energy + m * system.Matrices.Mass;
  const CombinedMatrix matrix(system.Matrices, a, m);
  const ComplexVector x = RandomVector(expected.cols(), 3);
  const ComplexVector product = expected * x;
  ComplexVector y;
  const double form = matrix.Multiply(x, y);
  const double rounding = 1e-14 * std::sqrt(product.squaredNorm() + x.squaredNorm());
  EXPECT_LT((y - product).norm(), 10.0 * rounding);
  EXPECT_NEAR(form, x.dot(product).real(), 1e-13 * std::abs(form));

  // Of a vector in single precision all digits that a result in single precision can have, one by one.
  const LargeArray<CompactComplex> compact(x.begin(), x.end());
  ComplexVector rounded(x.size());
  std::copy(compact.begin(), compact.end(), rounded.begin());
  const ComplexVector wide = expected * rounded;
  EXPECT_NEAR(matrix.Multiply(compact, y), rounded.dot(wide).real(), 1e-13 * std::abs(form));
  EXPECT_LT((y - wide).norm(), 10.0 * rounding);
  LargeArray<CompactComplex> narrow;
  EXPECT_NEAR(matrix.Multiply(compact, narrow), rounded.dot(wide).real(), 1e-13 * std::abs(form));
  ASSERT_EQ(narrow.size(), compact.size());
  for (Eigen::Index v = 0; v < wide.size(); ++v)
  {
    EXPECT_LE(std::abs(Complex(narrow[v]) - wide[v]), 1e-7 * std::abs(wide[v]) + 10.0 * rounding);
  }

  EXPECT_LT((LinearCombination(system.Matrices, a, m) - expected).norm(), 1e-15 * expected.norm());
}
}

TEST(CombinedMatrix, MultipliesLikeTheSum)
{
  // Of one block and of several, the last of which is not full.
  ASSERT_GT(Potato(5).Points.size(), 3u * CombinedMatrix::BlockRows);
  for (const Surface& surface : { Icosahedron(), Potato(5), Scrambled(Square(60), 5) })
  {
    ExpectProducts(surface, 1.0, 0.0);
    ExpectProducts(surface, 0.7, -0.3);
    ExpectProducts(surface, 0.0, 2.0);
  }
}
