// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PieceWithSurroundings_h
#define PieceWithSurroundings_h

#include "Mesh/Messages.h"
#include "Mesh/SharedPoints.h"
#include "Processes.h"
#include "Surface.h"
#include "SurfacePiece.h"

#include "vtkType.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// The triangles of a piece, and around them two rings of the triangles of other pieces: every
/// point of the piece, and every neighbour of it, has all its triangles here.
struct PieceWithSurroundings
{
  /// The input's points, then the points that only other pieces' triangles have. Points of several
  /// pieces are where their owner has them. The piece's own triangles, then the others', which are
  /// its ghosts.
  DirectionFields::Surface Surface;
  /// The number of each point (see SharedPoints); -1 where no triangle uses it.
  std::vector<vtkIdType> Number;
  /// The points that the input has.
  Index InputPoints = 0;
  /// For each own triangle that of the input.
  std::vector<Index> InputTriangle;
  /// The number of the first own triangle among the triangles of all pieces.
  vtkIdType FirstTriangle = 0;
  /// That of each process, and the number of all.
  std::vector<vtkIdType> FirstTriangles;
  /// Where components with only one side are covered (CoveredPiece): the input's points are the
  /// front ones and then as many back ones, its triangles the front ones and then those behind
  /// triangles of such components. Both are 0 elsewhere.
  Index FrontPoints = 0;
  Index FrontTriangles = 0;
  /// The number of each of the others' triangles.
  std::vector<vtkIdType> OthersTriangles;
};

/// Asks the other processes for the surroundings. All processes call it; throws ProcessesError.
/// @param input  the triangles of the piece, over all points of the polydata; its ghosts are left
/// out
PieceWithSurroundings AddSurroundings(Processes& processes, const Messages& messages,
  const DirectionFields::Surface& input, const SurfacePiece& piece, const SharedPoints& shared);
}

#endif
