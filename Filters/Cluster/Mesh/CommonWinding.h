// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CommonWinding_h
#define CommonWinding_h

#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Mesh/TriangleMesh.h"
#include "Processes.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// What WindAlike has found out of the whole surface; the same on all processes but for IsOneSided.
struct CommonWinding
{
  /// How many triangles are turned.
  Index Reversed = 0;
  /// How many components have only one side, as a Moebius strip has.
  Index OneSided = 0;
  /// Whether each of the piece's own triangles belongs to one of these.
  std::vector<char> IsOneSided;
};

/// Turns triangles so that each component of the whole surface that has two sides is wound like the
/// majority of its triangles; without a majority like the first of them, as on one process. All
/// processes call it; throws ProcessesError.
/// @param mesh     of the piece with its surroundings, whose parts are wound alike each for itself
/// @param piece    whose triangles are turned
CommonWinding WindAlike(Processes& processes, const Messages& messages, const TriangleMesh& mesh,
  PieceWithSurroundings& piece);
}

#endif
