// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedCurvature_h
#define DistributedCurvature_h

#include "Curvature/Curvature.h"
#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// The curvature of a surface in pieces, right at the vertices of the piece and next to it: each
/// step of its averages exchanges the values at the borders. All processes call it.
/// @param rings as in Curvature
Curvature CurvatureOf(const Messages& messages, const DistributedMesh& mesh,
  const PieceWithSurroundings& piece, double rings);

/// The share of the alignment's strength that each component of the whole surface has. All
/// processes call it.
std::vector<double> CurvatureShares(
  const Messages& messages, const DistributedMesh& mesh, const Curvature& curvature);
}

#endif
