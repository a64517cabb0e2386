// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CommonWinding_h
#define CommonWinding_h

#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Mesh/TriangleMesh.h"
#include "Processes.h"

namespace DirectionFields::Parallel
{
/// Turns triangles so that each component of the whole surface is wound like the majority of its
/// triangles; without a majority like the first of them, as on one process. All processes call it;
/// throws ProcessesError.
/// @param mesh     of the piece with its surroundings, whose parts are wound alike each for itself
/// @param piece    whose triangles are turned
/// @param reversed becomes how many of the whole surface are
/// @return false where the pieces cannot be wound alike, which changes nothing
bool WindAlike(Processes& processes, const Messages& messages, const TriangleMesh& mesh,
  PieceWithSurroundings& piece, Index& reversed);
}

#endif
