// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CoveredPiece_h
#define CoveredPiece_h

#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Mesh/SharedPoints.h"
#include "Mesh/TriangleMesh.h"
#include "Processes.h"
#include "SurfacePiece.h"

#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
/// Whether the meshes of the pieces are covered, and by what.
struct Covering
{
  /// Empty, or why there is no cover, as a part of a sentence. The same on all processes.
  std::string Reason;
  /// How points of both sides are shared.
  SharedPoints Shared;
  PieceWithSurroundings Piece;
};

/// The orientable double cover of the components that have only one side, over all processes: each
/// of their points and triangles is there twice, once for each side of the surface. The side of a
/// point that its front has is that of its first triangle, counted over all processes, so that all
/// processes with the point choose the same one without asking. All processes call it; throws
/// ProcessesError.
/// @param piece      whose triangles are wound as they are to be where there are two sides
/// @param isOneSided of each of its own triangles
Covering CoverOneSided(Processes& processes, const Messages& messages, const SurfacePiece& own,
  const SharedPoints& shared, const PieceWithSurroundings& piece,
  const std::vector<char>& isOneSided);

/// The vertex on the other side of the surface from each vertex of a covered piece; None where
/// there is none.
std::vector<Index> VerticesBehind(const TriangleMesh& mesh, const PieceWithSurroundings& piece);
}

#endif
