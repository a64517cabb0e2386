// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PieceMatching_h
#define PieceMatching_h

#include "vtkType.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
/// The pieces of a surface, one after another.
struct Pieces
{
  std::size_t Count() const { return this->FirstPoint.size() - 1; }
  /// The piece of a point.
  std::size_t PieceOf(vtkIdType point) const;

  /// The points of piece p are FirstPoint[p] ... FirstPoint[p + 1] - 1.
  std::vector<vtkIdType> FirstPoint;
  /// Three of each point, finite.
  std::vector<double> Coordinates;
  /// The global id of each point; empty where a piece has none.
  std::vector<vtkIdType> GlobalIds;
  /// The ends of the edges that only one triangle of their piece has, two points each.
  std::vector<vtkIdType> BorderEdges;
};

/// The points of the whole surface.
struct JoinedPoints
{
  /// For each point of the pieces its number, which ascends with the first points that have it.
  std::vector<vtkIdType> Number;
  vtkIdType Count = 0;
  /// How many of them belong to several pieces.
  vtkIdType Shared = 0;
  /// Points of the pieces that stay apart from another one within the tolerance, because a piece
  /// has both, and that point. They are to take its place, so that they are joined wherever points
  /// of equal places are: two processes may have computed them, one has both now.
  std::vector<std::pair<vtkIdType, vtkIdType>> Moved;
};

/// Distance at which points are the same one, in parts of the largest coordinate: the difference,
/// in single precision, of a coordinate that two processes have computed for themselves.
constexpr double MatchingTolerance = 5e-7;

/// Whether points of the same id are at the same place on all pieces: only then the ids may be
/// trusted.
bool AreGlobalIdsRight(const Pieces& pieces, double tolerance);

/// Joins the points that several pieces have in common.
///
/// With global ids these are points of the same id. Without, they are points on the borders of
/// pieces, and the points inside of others that these lie on, at a distance of at most the
/// tolerance, the nearest first; no two points of one piece become one. Where a piece has several
/// points at the place, along a seam say, the ones that the border's edges join are joined. In
/// linear time but for sorting points on borders, and the result does not depend on chance.
/// @param tolerance a distance; halved until few points are as near to each other
JoinedPoints JoinPieces(const Pieces& pieces, double tolerance);

/// Points to look for.
struct WantedPoints
{
  std::vector<double> Coordinates;
  /// Empty where they have no global ids.
  std::vector<vtkIdType> GlobalIds;
};

/// For each wanted point the one of the pieces' points with its id, or where there are no ids the
/// nearest one within the tolerance; -1 where there is none.
std::vector<vtkIdType> FindPoints(
  const Pieces& pieces, const WantedPoints& wanted, double tolerance);
}

#endif
