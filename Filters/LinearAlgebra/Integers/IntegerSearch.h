// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntegerSearch_h
#define DirectionFields_IntegerSearch_h

#include "Types.h"

namespace DirectionFields::Internal
{
/// Better integers near the minimum of a quadratic energy. What is rounded greedily is far from the
/// best where many variables depend on each other, by a third of the energy, or by a factor of 50
/// around a gear's teeth. From each variable that goes up or down by one, others follow, the one
/// that lowers the energy most at each step, as long as one does, and the best of these states is
/// kept if it is below the one before (S. Lin, B. Kernighan: An Effective Heuristic Algorithm for
/// the Traveling-Salesman Problem, 1973). The search takes
/// time quadratic in their number, the product of factors before it cubic time.
/// @param factor  lower triangular: factor factor^T is the matrix of the energy
/// @param relaxed where the energy is least
/// @param x       integers at or above least; become ones of no higher energy
/// @param least   of each variable, an integer or minus infinity; empty for no bounds
void ImproveIntegers(const Eigen::MatrixXd& factor, const Eigen::VectorXd& relaxed,
  Eigen::VectorXd& x, const Eigen::VectorXd& least = {});
}

#endif
