// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TriangularSquares_h
#define DirectionFields_TriangularSquares_h

#include <Eigen/Core>

namespace DirectionFields::Internal
{
/// L L^T of the lower triangle L of a matrix, both of its halves. In blocks that leave the zeros
/// out, a sixth of the work of a product, and shared among threads with the same bytes for any
/// number of them.
Eigen::MatrixXd SquareOf(const Eigen::MatrixXd& lower);

/// The inverse of L L^T in the same way. No diagonal element may be 0.
Eigen::MatrixXd InverseSquareOf(const Eigen::MatrixXd& lower);
}

#endif
