// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/FreeVertices.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

using namespace DirectionFields;

namespace
{
/// Every entry tells its row and column; the matrix is not Hermitian, so that rows and columns cannot be
/// mistaken for each other.
Eigen::MatrixXcd Numbered(Index n)
{
  Eigen::MatrixXcd dense(n, n);
  for (Index row = 0; row < n; ++row)
  {
    for (Index column = 0; column < n; ++column)
    {
      dense(row, column) =
        (row + 2 * column) % 3 == 0 ? Complex(0.0) : Complex(row + 1.0, column + 1.0);
    }
  }
  return dense;
}
}

TEST(FreeVertices, MatricesAndVectorsAreThoseOfTheFreeRowsAndColumns)
{
  constexpr Index n = 7;
  const GivenValues given{ { 5, 0, 3 },
    Eigen::Vector3cd(Complex(1.0, 5.0), 2.0, Complex(0.0, 3.0)) };
  const FreeVertices free(given.Vertices, n);
  const std::vector<Index> expected{ 1, 2, 4, 6 };
  ASSERT_EQ(free.GetVertices(), expected);
  EXPECT_FALSE(free.IsEmpty());

  const Eigen::MatrixXcd dense = Numbered(n);
  const SparseMatrix matrix = dense.sparseView();
  EXPECT_EQ(Eigen::MatrixXcd(free.Principal(matrix)), Eigen::MatrixXcd(dense(expected, expected)));
  EXPECT_EQ(Eigen::MatrixXcd(free.Columns(matrix)),
    Eigen::MatrixXcd(dense(Eigen::indexing::all, expected)));

  const ComplexVector all = dense.col(2);
  const ComplexVector gathered = free.Gathered(all);
  EXPECT_EQ(gathered, ComplexVector(all(expected)));

  const ComplexVector scattered = free.Scattered(given);
  EXPECT_EQ(ComplexVector(scattered(given.Vertices)), given.Values);
  EXPECT_EQ(ComplexVector(scattered(expected)), ComplexVector(ComplexVector::Zero(4)));
  EXPECT_EQ(free.Joined(gathered, given),
    ComplexVector(scattered + free.Joined(gathered, { given.Vertices, ComplexVector::Zero(3) })));
  EXPECT_EQ(ComplexVector(free.Joined(gathered, given)(expected)), gathered);
}

TEST(FreeVertices, AllOrNoneOfThemCanBeFree)
{
  const SparseMatrix matrix = Numbered(3).sparseView();
  const FreeVertices all({}, 3);
  EXPECT_EQ(Eigen::MatrixXcd(all.Principal(matrix)), Numbered(3));
  const FreeVertices none({ 2, 1, 0 }, 3);
  EXPECT_TRUE(none.IsEmpty());
  EXPECT_EQ(none.Principal(matrix).cols(), 0);
  EXPECT_EQ(none.Columns(matrix).rows(), 3);
  EXPECT_EQ(none.Joined({}, { { 2, 1, 0 }, Eigen::Vector3cd(1.0, 2.0, 3.0) }),
    ComplexVector(Eigen::Vector3cd(3.0, 2.0, 1.0)));
}
