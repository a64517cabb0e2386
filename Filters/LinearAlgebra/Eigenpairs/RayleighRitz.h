// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RayleighRitz_h
#define DirectionFields_RayleighRitz_h

#include "Multigrid/SectionBlock.h"

namespace DirectionFields::Internal
{
/// The smallest pairs of a projected eigenvalue problem.
struct RitzPairs
{
  /// Ascending.
  Eigen::VectorXd Values;
  /// Coefficients of the vectors in the basis, orthonormal in its mass matrix.
  SmallMatrix Vectors;
};

/// The Ritz pairs of a basis V, whose vectors may be nearly dependent and of any length.
/// @param energy, mass V^* A V and V^* M V
/// @param wanted       the most pairs; there are fewer where the basis does not have them, and none
///                     where the matrices have values that are not finite
RitzPairs RayleighRitz(const SmallMatrix& energy, const SmallMatrix& mass, int wanted);
}

#endif
