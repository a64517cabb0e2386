// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LoopHolonomies_h
#define DirectionFields_LoopHolonomies_h

#include "TrivialConnection/TreeCotree.h"

#include <vector>

namespace DirectionFields::Internal
{
/// How often a field of degree n turns against the tangent of each loop of a component, in units of
/// 1/n.
/// @param rotation of the field along the edges
std::vector<int> LoopHolonomies(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const TreeCotree& trees,
  const EdgeForm& rotation);

/// The integers x for which x^T G x / 2 + g^T x is small: the least real numbers, rounded, then
/// changed by 1 one at a time as long as that makes it smaller.
/// @param products G, positive definite
/// @param slope    g
Eigen::VectorXi NearestIntegers(const Eigen::MatrixXd& products, const Eigen::VectorXd& slope);
}

#endif
