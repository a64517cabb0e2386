// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/TriangularSquares.h"

#include "Support/Threads.h"

#include <Eigen/Dense>

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
constexpr Eigen::Index BlockSize = 64;

/// Calls body(begin, size) for blocks of up to so many columns, the last ones first: they have the
/// most to do where a block depends on those before it.
template <typename Body>
void ForBlocks(Eigen::Index count, const Body& body)
{
  const Eigen::Index blocks = (count + BlockSize - 1) / BlockSize;
  Threads::Run(static_cast<Index>(blocks),
    [&](Index piece)
    {
      const Eigen::Index begin = (blocks - 1 - piece) * BlockSize;
      body(begin, std::min(BlockSize, count - begin));
    });
}

/// Copies what is below the diagonal to the other half.
void Mirror(Eigen::MatrixXd& matrix)
{
  ForBlocks(matrix.cols(),
    [&](Eigen::Index begin, Eigen::Index size)
    {
      for (Eigen::Index j = begin; j < begin + size; ++j)
      {
        matrix.col(j).head(j) = matrix.row(j).head(j).transpose();
      }
    });
}
}

Eigen::MatrixXd SquareOf(const Eigen::MatrixXd& lower)
{
  const Eigen::Index count = lower.rows();
  const Eigen::MatrixXd factor = lower.triangularView<Eigen::Lower>();
  Eigen::MatrixXd square(count, count);
  // Rows are as long as they have columns up to the diagonal.
  ForBlocks(count,
    [&](Eigen::Index begin, Eigen::Index size)
    {
      for (Eigen::Index other = 0; other <= begin; other += BlockSize)
      {
        const Eigen::Index width = std::min(BlockSize, count - other);
        square.block(begin, other, size, width).noalias() =
          factor.block(begin, 0, size, other + width) *
          factor.block(other, 0, width, other + width).transpose();
      }
    });
  Mirror(square);
  return square;
}

Eigen::MatrixXd InverseSquareOf(const Eigen::MatrixXd& lower)
{
  const Eigen::Index count = lower.rows();
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(count, count);
  ForBlocks(count,
    [&](Eigen::Index begin, Eigen::Index size)
    {
      const Eigen::Index left = count - begin;
      Eigen::MatrixXd columns = Eigen::MatrixXd::Identity(left, size);
      lower.bottomRightCorner(left, left)
        .template triangularView<Eigen::Lower>()
        .solveInPlace(columns);
      inverse.block(begin, begin, left, size) = columns;
    });
  Eigen::MatrixXd square(count, count);
  ForBlocks(count,
    [&](Eigen::Index begin, Eigen::Index size)
    {
      const Eigen::Index left = count - begin;
      square.block(begin, 0, size, begin + size).noalias() =
        inverse.block(begin, begin, left, size).transpose() *
        inverse.block(begin, 0, left, begin + size);
    });
  Mirror(square);
  return square;
}
}
