// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntegerRounding_h
#define DirectionFields_IntegerRounding_h

#include "Types.h"

namespace DirectionFields::Internal
{
constexpr Eigen::Index MostSingly = 800;
/// More are not to be rounded like that: memory grows with their square, and time with their cube.
constexpr Eigen::Index MostRounded = 2000;

/// Integers near the minimum of a quadratic energy, found greedily: the variable that is nearest to
/// an integer gets it, the others move to where the energy is least with that, and so on (D.
/// Bommes, H. Zimmer, L. Kobbelt: Mixed-Integer Quadrangulation, 2009). Of equally near ones the
/// first goes first. Where there are more than mostSingly variables, ones that depend little on
/// each other are rounded together. Variables that are below their bounds go first, to the bounds,
/// so that the others have the most room.
/// @param factor lower triangular: factor factor^T is the matrix of the energy
/// @param x      where the energy is least; becomes the integers
/// @param least  of each variable, an integer or minus infinity; empty for no bounds
void RoundGreedily(const Eigen::MatrixXd& factor, Eigen::VectorXd& x,
  const Eigen::VectorXd& least = {}, Eigen::Index mostSingly = MostSingly);
}

#endif
